#include "SymbolicFactor.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace bolster {

namespace {

/// The entries right of or below the diagonal of a permuted matrix: those of each column or row.
struct Triangle {
    struct Item {
        int other = 0;  ///< the row or column
        int source = 0; ///< index of the value
    };
    std::vector<int> start;
    std::vector<Item> items;
};

/// With `byColumn` each column's rows from the diagonal on, else each row's columns up to the diagonal.
Triangle triangleOf(const Eigen::SparseMatrix<double>& lower, const std::vector<int>& position, bool byColumn)
{
    Triangle triangle;
    triangle.start.assign(static_cast<std::size_t>(lower.cols()) + 1, 0);
    const auto eachEntry = [&](auto visit) {
        for (int c = 0; c < lower.outerSize(); ++c)
            for (int k = lower.outerIndexPtr()[c]; k < lower.outerIndexPtr()[c + 1]; ++k) {
                const int a = position[c], b = position[lower.innerIndexPtr()[k]];
                const auto [low, high] = std::minmax(a, b);
                visit(byColumn ? low : high, byColumn ? high : low, k);
            }
    };
    eachEntry([&](int at, int, int) { ++triangle.start[at + 1]; });
    std::partial_sum(triangle.start.begin(), triangle.start.end(), triangle.start.begin());
    triangle.items.resize(static_cast<std::size_t>(triangle.start.back()));
    std::vector<int> next(triangle.start.begin(), triangle.start.end() - 1);
    eachEntry([&](int at, int other, int source) { triangle.items[next[at]++] = {other, source}; });
    return triangle;
}

/// The elimination tree (Liu, "The role of elimination trees in sparse factorization", 1990): the parent of each
/// column.
std::vector<int> eliminationTree(const Triangle& byRow)
{
    const int n = static_cast<int>(byRow.start.size()) - 1;
    std::vector<int> parent(n, -1), ancestor(n, -1);
    for (int row = 0; row < n; ++row)
        for (int k = byRow.start[row]; k < byRow.start[row + 1]; ++k)
            for (int c = byRow.items[k].other; c != -1 && c < row;) {
                const int above = std::exchange(ancestor[c], row);
                if (above == -1)
                    parent[c] = row;
                c = above;
            }
    return parent;
}

/// The columns, children before parents and whole subtrees together.
std::vector<int> postorder(const std::vector<int>& parent)
{
    const int n = static_cast<int>(parent.size());
    std::vector<int> firstChild(n, -1), sibling(n, -1), order, stack;
    order.reserve(n);
    for (int c = n - 1; c >= 0; --c)
        if (parent[c] >= 0)
            sibling[c] = std::exchange(firstChild[parent[c]], c);
    for (int root = 0; root < n; ++root) {
        if (parent[root] >= 0)
            continue;
        stack.assign(1, root);
        while (!stack.empty()) {
            const int c = stack.back();
            if (firstChild[c] >= 0) {
                stack.push_back(std::exchange(firstChild[c], -1));
                continue;
            }
            order.push_back(c);
            stack.pop_back();
            if (sibling[c] >= 0)
                stack.push_back(sibling[c]);
        }
    }
    return order;
}

/// The numbers in each column of the factor, the diagonal included.
std::vector<int> columnCounts(const Triangle& byRow, const std::vector<int>& parent)
{
    const int n = static_cast<int>(parent.size());
    std::vector<int> count(n, 1), seen(n, -1);
    for (int row = 0; row < n; ++row) {
        seen[row] = row;
        for (int k = byRow.start[row]; k < byRow.start[row + 1]; ++k)
            for (int c = byRow.items[k].other; seen[c] != row; c = parent[c]) {
                seen[c] = row;
                ++count[c];
            }
    }
    return count;
}

double sizeOf(int width, int height)
{
    return static_cast<double>(width) * height - 0.5 * width * (width - 1);
}

/// Zeros cost reading them twice in every solve, a node some dozen instructions and indices.
bool worthMerging(int width, double zeros, double size)
{
    if (width <= 12)
        return true;
    const double share = width <= 16 ? 0.4 : width <= 48 ? 0.15 : 0.05;
    return zeros < share * size;
}

/// Widths and heights of the nodes; the rows come later.
std::vector<SupernodeShape> supernodes(const std::vector<int>& parent, const std::vector<int>& count)
{
    struct Growing {
        SupernodeShape shape;
        double numbers = 0; ///< those that are not zero
    };
    const int n = static_cast<int>(parent.size());
    std::vector<Growing> nodes;
    for (int c = 0; c < n; ++c) {
        const bool goesOn = c > 0 && parent[c - 1] == c && count[c - 1] == count[c] + 1;
        if (!goesOn) {
            // The node before has ended. It goes into its parent while that is the next one; see below.
            nodes.push_back({{c, 0, 0}, 0});
        }
        ++nodes.back().shape.width;
        nodes.back().shape.below = count[c] - 1;
        nodes.back().numbers += count[c];
    }
    std::vector<Growing> merged;
    for (Growing node : nodes) {
        const int last = node.shape.first + node.shape.width;
        while (!merged.empty()) {
            const Growing& before = merged.back();
            const int above = parent[node.shape.first - 1]; // of the last column of the node before
            const int width = before.shape.width + node.shape.width;
            const double size = sizeOf(width, width + node.shape.below);
            const double numbers = before.numbers + node.numbers;
            if (above < 0 || above >= last || !worthMerging(width, size - numbers, size))
                break;
            node = {{before.shape.first, width, node.shape.below}, numbers};
            merged.pop_back();
        }
        merged.push_back(node);
    }
    std::vector<SupernodeShape> shapes;
    std::vector<int> nodeOf(n);
    for (const Growing& node : merged) {
        std::fill_n(nodeOf.begin() + node.shape.first, node.shape.width, static_cast<int>(shapes.size()));
        shapes.push_back(node.shape);
    }
    for (SupernodeShape& shape : shapes)
        if (const int above = parent[shape.first + shape.width - 1]; above >= 0)
            shape.parent = nodeOf[above];
    return shapes;
}

/// Divides the forest of nodes into two halves of like work (0, 1) and what lies above both (2): the heaviest
/// subtree is opened until the halves are even or its root is too small to matter.
std::vector<int> halvesOf(const std::vector<SupernodeShape>& nodes)
{
    constexpr double even = 0.05; // of all work
    constexpr int mostOpened = 64;
    const int count = static_cast<int>(nodes.size());
    std::vector<double> below(count); // with all descendants
    std::vector<std::vector<int>> children(count);
    std::vector<int> roots, subtreeHalf, half(count, 0);
    double all = 0;
    for (int s = 0; s < count; ++s) {
        const double work = static_cast<double>(nodes[s].width) * nodes[s].height();
        all += work;
        below[s] += work;
        if (nodes[s].parent < 0)
            roots.push_back(s);
        else {
            below[nodes[s].parent] += below[s];
            children[nodes[s].parent].push_back(s);
        }
    }
    for (int opened = 0;; ++opened) {
        std::ranges::sort(roots, [&](int a, int b) { return std::pair(-below[a], a) < std::pair(-below[b], b); });
        double load[2] = {0, 0};
        subtreeHalf.clear();
        for (const int root : roots) {
            subtreeHalf.push_back(load[0] <= load[1] ? 0 : 1);
            load[subtreeHalf.back()] += below[root];
        }
        if (opened == mostOpened || std::abs(load[0] - load[1]) < even * all || children[roots.front()].empty())
            break;
        const int opening = roots.front();
        half[opening] = 2;
        roots.front() = children[opening].back();
        roots.insert(roots.end(), children[opening].begin(), children[opening].end() - 1);
    }
    for (std::size_t r = 0; r < roots.size(); ++r)
        half[roots[r]] = subtreeHalf[r];
    for (int s = count - 1; s >= 0; --s)
        if (nodes[s].parent >= 0 && half[nodes[s].parent] != 2)
            half[s] = half[nodes[s].parent];
    return half;
}

/// What a node's columns and children leave for the rows below it, and where the matrix' entries go.
void fillNodes(const Triangle& byColumn, SymbolicFactor& factor)
{
    const int n = static_cast<int>(byColumn.start.size()) - 1;
    std::vector<int> seen(n, -1), place(n);
    std::vector<int> lastChild(factor.nodes.size(), -1), sibling(factor.nodes.size(), -1);
    factor.entries.reserve(byColumn.items.size());
    for (int s = 0; s < std::ssize(factor.nodes); ++s) {
        SupernodeShape& node = factor.nodes[s];
        const int end = node.first + node.width;
        node.rows = factor.rows.size();
        const auto add = [&](int row) {
            if (row >= end && seen[row] != s) {
                seen[row] = s;
                factor.rows.push_back(row);
            }
        };
        for (int k = byColumn.start[node.first]; k < byColumn.start[end]; ++k)
            add(byColumn.items[k].other);
        for (int child = lastChild[s]; child >= 0; child = sibling[child])
            for (int r = 0; r < factor.nodes[child].below; ++r)
                add(factor.rows[factor.nodes[child].rows + static_cast<std::size_t>(r)]);
        const auto first = factor.rows.begin() + static_cast<std::ptrdiff_t>(node.rows);
        std::sort(first, factor.rows.end());
        node.below = static_cast<int>(factor.rows.end() - first);
        if (node.parent >= 0)
            sibling[s] = std::exchange(lastChild[node.parent], s);

        for (int r = 0; r < node.below; ++r)
            place[first[r]] = node.width + r;
        std::iota(place.begin() + node.first, place.begin() + end, 0);
        node.entries = factor.entries.size();
        for (int c = node.first; c < end; ++c)
            for (int k = byColumn.start[c]; k < byColumn.start[c + 1]; ++k)
                factor.entries.push_back(
                    {byColumn.items[k].source, (c - node.first) * node.height() + place[byColumn.items[k].other]});
        node.entryCount = static_cast<int>(factor.entries.size() - node.entries);
    }
}

/// Brings the halves together: first half, second half, what parts them.
void arrange(SymbolicFactor& factor, const std::vector<int>& order)
{
    const std::vector<int> half = halvesOf(factor.nodes);
    std::vector<int> sorted(factor.nodes.size()), place(factor.nodes.size()), column(order.size());
    std::iota(sorted.begin(), sorted.end(), 0);
    std::stable_sort(sorted.begin(), sorted.end(), [&](int a, int b) { return half[a] < half[b]; });
    std::vector<SupernodeShape> nodes;
    int next = 0;
    for (const int s : sorted) {
        SupernodeShape node = factor.nodes[s];
        std::iota(column.begin() + node.first, column.begin() + node.first + node.width, next);
        place[s] = static_cast<int>(nodes.size());
        node.first = next;
        next += node.width;
        nodes.push_back(node);
    }
    for (SupernodeShape& node : nodes)
        if (node.parent >= 0)
            node.parent = place[node.parent];
    for (int& row : factor.rows)
        row = column[row];
    factor.nodes = std::move(nodes);
    for (int p = 0; p < 3; ++p)
        factor.partStart[p] =
            static_cast<std::size_t>(std::ranges::count_if(half, [&](int inHalf) { return inHalf < p; }));
    factor.partStart[3] = factor.nodes.size();
    factor.slots.resize(order.size());
    for (std::size_t k = 0; k < order.size(); ++k)
        factor.slots[order[k]] = column[k];
}

std::vector<int> positions(const std::vector<int>& order)
{
    std::vector<int> position(order.size());
    for (std::size_t k = 0; k < order.size(); ++k)
        position[order[k]] = static_cast<int>(k);
    return position;
}

} // namespace

SymbolicFactor::SymbolicFactor(const Eigen::SparseMatrix<double>& lower, std::vector<int> order)
{
    if (order.empty())
        return;
    const std::vector<int> tree = eliminationTree(triangleOf(lower, positions(order), false));
    const std::vector<int> post = postorder(tree);
    std::vector<int> arranged(order.size());
    for (std::size_t k = 0; k < order.size(); ++k)
        arranged[k] = order[post[k]];
    const std::vector<int> back = positions(post), position = positions(arranged);
    std::vector<int> parent(order.size());
    for (std::size_t k = 0; k < order.size(); ++k)
        parent[k] = tree[post[k]] < 0 ? -1 : back[tree[post[k]]];
    nodes = supernodes(parent, columnCounts(triangleOf(lower, position, false), parent));
    fillNodes(triangleOf(lower, position, true), *this);
    arrange(*this, arranged);
}

int SymbolicFactor::outside() const
{
    return partStart[2] < nodes.size() ? nodes[partStart[2]].first : size();
}

} // namespace bolster
