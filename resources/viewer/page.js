// The viewer of a page for customers: turns, zooms, switches colourways, shows seams and measures.
(function () {
    "use strict";

    const words = {
        en: {
            seams: "Seams", size: "Size", measure: "Measure", home: "Start view",
            first: "Tap two points on the model", second: "Tap the second point",
            noView: "This browser cannot draw in 3D (WebGL is missing or switched off).",
            tooOld: "This browser is too old for this page.",
            width: "width", depth: "depth", height: "height"
        },
        de: {
            seams: "N\u00e4hte", size: "Ma\u00dfe", measure: "Messen", home: "Anfangsansicht",
            first: "Zwei Punkte am Modell antippen", second: "Den zweiten Punkt antippen",
            noView: "Dieser Browser kann nicht in 3D zeichnen (WebGL fehlt oder ist abgeschaltet).",
            tooOld: "Dieser Browser ist zu alt f\u00fcr diese Seite.",
            width: "Breite", depth: "Tiefe", height: "H\u00f6he"
        }
    };
    const seamColor = 0xe4572e, chosenColor = 0x1f6feb;
    const language = (navigator.language || "en").slice(0, 2) === "de" ? "de" : "en";
    const say = words[language];
    document.documentElement.lang = language;

    const find = id => document.getElementById(id);
    const facts = JSON.parse(find("facts").textContent);
    const canvas = find("view"), hint = find("hint");
    const millimetres = length => Math.round(length).toLocaleString(language) + " mm";

    find("size").textContent =
        [facts.size[0], facts.size[1], facts.size[2]].map(n => Math.round(n).toLocaleString(language)).join(" \u00d7 ") +
        " mm (" + [say.width, say.depth, say.height].join(" \u00d7 ") + ")";
    for (const [id, word] of [["show-seams", say.seams], ["show-size", say.size], ["measure", say.measure],
                              ["home", say.home]])
        find(id).textContent = word;

    let renderer;
    try {
        renderer = new THREE.WebGLRenderer({ canvas: canvas, antialias: true, alpha: true });
    } catch (error) {
        hint.textContent = say.noView;
        return;
    }
    renderer.gammaOutput = true;
    renderer.gammaFactor = 2.2;
    renderer.shadowMap.enabled = true;
    renderer.shadowMap.type = THREE.PCFSoftShadowMap;
    renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));

    const scene = new THREE.Scene();
    const camera = new THREE.PerspectiveCamera(30, 1, 0.05, 60);
    const controls = new THREE.OrbitControls(camera, canvas);
    controls.enableKeys = false; // its keys would move the whole page's
    controls.maxPolarAngle = Math.PI * 0.55;

    /** Drawn only when something has changed: phones have batteries. */
    let wanted = false;
    function draw() {
        if (wanted)
            return;
        wanted = true;
        requestAnimationFrame(function () {
            wanted = false;
            renderer.render(scene, camera);
            placeLabels();
        });
    }
    controls.addEventListener("change", draw);

    // What stands in the room: words at places.
    const labels = [];
    function label(text, at) {
        const span = document.createElement("span");
        span.textContent = text;
        find("labels").appendChild(span);
        const made = { span: span, at: at };
        labels.push(made);
        return made;
    }
    function unlabel(made) {
        labels.splice(labels.indexOf(made), 1);
        made.span.remove();
    }
    function placeLabels() {
        for (const made of labels) {
            const p = made.at.clone().project(camera);
            made.span.hidden = p.z > 1;
            made.span.style.left = (p.x + 1) / 2 * canvas.clientWidth + "px";
            made.span.style.top = (1 - p.y) / 2 * canvas.clientHeight + "px";
        }
    }

    // A studio: a large window, light from the sky and the floor, and what shiny things reflect of it.
    function side(from, to, lamp) {
        const face = document.createElement("canvas");
        face.width = face.height = 64;
        const paint = face.getContext("2d");
        const shade = paint.createLinearGradient(0, 0, 0, 64);
        shade.addColorStop(0, from);
        shade.addColorStop(1, to);
        paint.fillStyle = shade;
        paint.fillRect(0, 0, 64, 64);
        if (lamp) {
            paint.fillStyle = "#ffffff";
            paint.fillRect(14, 10, 36, 30);
        }
        return face;
    }
    const around = new THREE.CubeTexture([side("#d9dde2", "#8d8780", true), side("#d2d6dc", "#8d8780", false),
                                          side("#ffffff", "#ffffff", false), side("#8a847d", "#8a847d", false),
                                          side("#d9dde2", "#8d8780", true), side("#c9cdd3", "#8d8780", false)]);
    around.encoding = THREE.sRGBEncoding;
    around.generateMipmaps = true;
    around.minFilter = THREE.LinearMipmapLinearFilter;
    around.needsUpdate = true;

    function light(size) {
        scene.add(new THREE.HemisphereLight(0xffffff, 0xa79d92, 0.5));
        const key = new THREE.DirectionalLight(0xfff4e6, 1.25);
        key.position.set(1.1, 1.35, 1.3).multiplyScalar(size);
        key.castShadow = true;
        key.shadow.mapSize.set(2048, 2048);
        key.shadow.radius = 3;
        key.shadow.bias = -0.003;
        const view = key.shadow.camera;
        view.left = view.bottom = -size;
        view.right = view.top = size;
        view.near = 0.1;
        view.far = 5 * size;
        scene.add(key);
        const rim = new THREE.DirectionalLight(0xdfe9ff, 0.45);
        rim.position.set(-1.2, 0.9, -1.1).multiplyScalar(size);
        scene.add(rim);
    }

    /** Dark where it stands, and where the key light does not fall. */
    function floor(size) {
        const spot = document.createElement("canvas");
        spot.width = spot.height = 128;
        const paint = spot.getContext("2d");
        const shade = paint.createRadialGradient(64, 64, 8, 64, 64, 64);
        shade.addColorStop(0, "rgba(0, 0, 0, 0.45)");
        shade.addColorStop(0.55, "rgba(0, 0, 0, 0.22)");
        shade.addColorStop(1, "rgba(0, 0, 0, 0)");
        paint.fillStyle = shade;
        paint.fillRect(0, 0, 128, 128);
        const below = new THREE.Mesh(
            new THREE.PlaneBufferGeometry(1.5 * size.x, 1.5 * size.z),
            new THREE.MeshBasicMaterial({ map: new THREE.CanvasTexture(spot), transparent: true, depthWrite: false }));
        below.rotation.x = -Math.PI / 2;
        below.position.y = -0.002;
        scene.add(below);
        const far = 6 * Math.max(size.x, size.z);
        const ground = new THREE.Mesh(new THREE.PlaneBufferGeometry(far, far),
                                      new THREE.ShadowMaterial({ opacity: 0.18, depthWrite: false }));
        ground.rotation.x = -Math.PI / 2;
        ground.position.y = -0.003;
        ground.receiveShadow = true;
        scene.add(ground);
    }

    const bytes = Uint8Array.from(atob(find("model").textContent.trim()), c => c.charCodeAt(0));
    find("model").textContent = "";
    const fail = error => { hint.textContent = String(error); };
    if (window.DecompressionStream)
        new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"))).arrayBuffer()
            .then(buffer => new THREE.GLTFLoader().parse(buffer, "", show, fail)).catch(fail);
    else
        fail(say.tooOld);

    function show(gltf) {
        const root = gltf.scene.children[0];
        scene.add(gltf.scene);
        gltf.scene.updateMatrixWorld(true);
        const box = new THREE.Box3().setFromObject(gltf.scene);
        const size = box.getSize(new THREE.Vector3()), middle = box.getCenter(new THREE.Vector3());
        light(size.length());
        floor(size);

        function home() {
            const half = 0.5 * size.length();
            const narrow = Math.min(1, camera.aspect);
            const away = 1.15 * half / Math.sin(camera.fov * Math.PI / 360) / narrow;
            const direction = new THREE.Vector3(0.62, 0.36, 1).normalize();
            controls.target.copy(middle);
            camera.position.copy(middle).addScaledVector(direction, away);
            controls.minDistance = 0.25 * half;
            controls.maxDistance = 4 * away;
            controls.update();
            draw();
        }
        function fit() {
            renderer.setSize(window.innerWidth, window.innerHeight, false);
            camera.aspect = window.innerWidth / Math.max(1, window.innerHeight);
            camera.updateProjectionMatrix();
            draw();
        }
        window.addEventListener("resize", fit);
        find("home").addEventListener("click", home);

        const seams = seamLines(root), dimensions = sizeLines(box);
        wearColourways(gltf, fit);
        toggle("show-seams", function (on) {
            seams.all.visible = on;
            find("seams").hidden = !on;
        });
        toggle("show-size", function (on) { dimensions(on); });
        measuring(gltf.scene);
        fit();
        home();
        document.documentElement.dataset.ready = "yes"; // whoever drives the page from outside may begin
    }

    function toggle(id, act) {
        const button = find(id);
        button.addEventListener("click", function () {
            const on = button.getAttribute("aria-pressed") !== "true";
            button.setAttribute("aria-pressed", String(on));
            act(on);
            draw();
        });
    }

    /** The materials of a colourway, and the texture coordinates that they are for. */
    function wearColourways(gltf, drawn) {
        const json = gltf.parser.json, variants = json.extensions && json.extensions.KHR_materials_variants;
        const names = variants ? variants.variants : [];
        const meshes = json.meshes.map((_, m) => gltf.parser.getDependency("mesh", m));
        function dress(mesh, index, material) {
            const surface = json.materials[index].pbrMetallicRoughness;
            const map = surface.baseColorTexture || json.materials[index].normalTexture;
            const geometry = mesh.geometry;
            geometry.userData.sets = geometry.userData.sets || [geometry.attributes.uv, geometry.attributes.uv2];
            const set = geometry.userData.sets[map && map.texCoord || 0];
            if (set)
                geometry.setAttribute("uv", set);
            material.envMap = around;
            material.envMapIntensity = surface.metallicFactor > 0 ? 1 : 0.35;
            for (const each of [material.map, material.normalMap, material.roughnessMap])
                if (each && each.anisotropy !== 8) {
                    each.anisotropy = 8;
                    each.needsUpdate = true;
                }
            mesh.material = material;
            gltf.parser.assignFinalMaterial(mesh);
            mesh.castShadow = mesh.receiveShadow = true;
        }
        function wear(variant) {
            return Promise.all(meshes.map((promise, m) => promise.then(function (group) {
                const primitive = json.meshes[m].primitives[0], own = primitive.extensions;
                const mapping = own && own.KHR_materials_variants &&
                    own.KHR_materials_variants.mappings.find(each => each.variants.includes(variant));
                const index = mapping ? mapping.material : primitive.material;
                return gltf.parser.getDependency("material", index).then(function (material) {
                    group.traverse(function (mesh) {
                        if (mesh.isMesh)
                            dress(mesh, index, material);
                    });
                });
            }))).then(drawn);
        }
        const buttons = names.map(function (variant, v) {
            const button = document.createElement("button"), dot = document.createElement("i");
            button.type = "button";
            dot.style.background = facts.colors[v];
            button.append(dot, variant.name);
            button.setAttribute("aria-pressed", String(v === 0));
            button.addEventListener("click", function () {
                buttons.forEach(each => each.setAttribute("aria-pressed", String(each === button)));
                wear(v);
            });
            find("colourways").appendChild(button);
            return button;
        });
        wear(0);
    }

    function line(points, color) {
        const geometry = new THREE.BufferGeometry();
        geometry.setAttribute("position", new THREE.Float32BufferAttribute(points, 3));
        return new THREE.Line(geometry, new THREE.LineBasicMaterial({ color: color }));
    }

    /** A seam as a line, faint where something is before it. */
    function seamLine(points) {
        const group = new THREE.Group(), seen = line(points, seamColor), behind = line(points, seamColor);
        Object.assign(behind.material, { depthTest: false, transparent: true, opacity: 0.35 });
        behind.renderOrder = 1;
        group.add(seen, behind);
        group.choose = function (chosen) {
            for (const each of [seen, behind])
                each.material.color.set(chosen ? chosenColor : seamColor);
            behind.material.opacity = chosen ? 1 : 0.35;
        };
        return group;
    }

    /** The seams as lines, and a list of them: what is chosen there is marked. */
    function seamLines(root) {
        const all = new THREE.Group();
        let chosen = null, mark = null;
        facts.seams.forEach(function (seam) {
            const drawn = seamLine(seam.line.map(n => n / 1000));
            all.add(drawn);
            const item = document.createElement("li"), button = document.createElement("button");
            const length = document.createElement("b");
            length.textContent = millimetres(seam.length);
            button.type = "button";
            button.append(seam.name, length);
            button.addEventListener("click", function () {
                if (mark)
                    unlabel(mark);
                if (chosen)
                    chosen.line.choose(false), chosen.button.removeAttribute("aria-pressed");
                mark = null;
                chosen = chosen && chosen.line === drawn ? null : { line: drawn, button: button };
                if (chosen) {
                    drawn.choose(true);
                    button.setAttribute("aria-pressed", "true");
                    const half = 3 * Math.floor(seam.line.length / 6);
                    const at = new THREE.Vector3().fromArray(seam.line, half).divideScalar(1000);
                    mark = label(millimetres(seam.length), root.localToWorld(at));
                }
                draw();
            });
            item.appendChild(button);
            find("seams").firstElementChild.appendChild(item);
        });
        all.visible = false;
        root.add(all);
        return { all: all };
    }

    /** Width, depth and height along the edges of the box that stand in front. */
    function sizeLines(box) {
        const group = new THREE.Group(), a = box.min, b = box.max, gap = 0.05;
        const edges = [[[a.x, a.y, b.z + gap], [b.x, a.y, b.z + gap], facts.size[0]],
                       [[b.x + gap, a.y, a.z], [b.x + gap, a.y, b.z], facts.size[1]],
                       [[b.x + gap, a.y, a.z], [b.x + gap, b.y, a.z], facts.size[2]]];
        for (const [from, to] of edges)
            group.add(line(from.concat(to), 0x22262b));
        let shown = [];
        return function (on) {
            scene.remove(group);
            shown.forEach(unlabel);
            shown = [];
            if (!on)
                return;
            scene.add(group);
            shown = edges.map(function (edge) {
                const from = new THREE.Vector3().fromArray(edge[0]), to = new THREE.Vector3().fromArray(edge[1]);
                return label(millimetres(edge[2]), from.add(to).multiplyScalar(0.5));
            });
        };
    }

    /** Between two points that are tapped. A finger that moves turns the model instead. */
    function measuring(model) {
        const button = find("measure"), rays = new THREE.Raycaster();
        let points = [], shown = null, words = null, pressed = null;
        function clear() {
            points = [];
            if (shown)
                scene.remove(shown);
            if (words)
                unlabel(words);
            shown = words = null;
        }
        toggle("measure", function (on) {
            clear();
            hint.textContent = on ? say.first : "";
        });
        function take(x, y) {
            const at = { x: x / canvas.clientWidth * 2 - 1, y: 1 - y / canvas.clientHeight * 2 };
            rays.setFromCamera(at, camera);
            const hit = rays.intersectObject(model, true).find(each => each.object.isMesh);
            if (!hit)
                return;
            if (points.length === 2)
                clear();
            points.push(hit.point);
            if (points.length === 1) {
                shown = new THREE.Group();
                scene.add(shown);
            }
            const ball = new THREE.Mesh(new THREE.SphereBufferGeometry(0.006, 16, 12),
                                        new THREE.MeshBasicMaterial({ color: 0x1f6feb, depthTest: false }));
            ball.position.copy(hit.point);
            ball.renderOrder = 1;
            shown.add(ball);
            hint.textContent = points.length === 1 ? say.second : "";
            if (points.length === 2) {
                const between = line(points[0].toArray().concat(points[1].toArray()), 0x1f6feb);
                between.material.depthTest = false;
                shown.add(between);
                words = label(millimetres(1000 * points[0].distanceTo(points[1])),
                              points[0].clone().lerp(points[1], 0.5));
            }
            draw();
        }
        canvas.addEventListener("pointerdown", event => pressed = event.isPrimary ? event : null);
        canvas.addEventListener("pointerup", function (event) {
            const moved = pressed && Math.hypot(event.clientX - pressed.clientX, event.clientY - pressed.clientY);
            if (pressed && moved < 8 && button.getAttribute("aria-pressed") === "true")
                take(event.clientX, event.clientY);
            pressed = null;
        });
    }
})();
