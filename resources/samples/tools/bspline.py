"""B-splines as docs/design-json.md defines them, for the scripts that make the samples."""

from bisect import bisect_right
from math import dist, floor


class BSpline:
    """A curve from its text form: evaluation, length and positions at equal fractions of the length."""

    def __init__(self, form):
        self.degree = form["degree"]
        self.closed = form.get("closed", False)
        self.points = form["points"]
        self.knots = form.get("knots") or self._default_knots(form.get("corners"))
        n = len(self.points)
        self.start, self.end = (
            (self.knots[0], self.knots[n]) if self.closed else (self.knots[self.degree], self.knots[n]))
        self._table = None

    def _default_knots(self, corners):
        n, d = len(self.points), self.degree
        if not self.closed:
            return [0.0] * d + [float(i) for i in range(n - d + 1)] + [float(n - d)] * d
        if not corners:
            return [float(i) for i in range(n + 1)]
        knots = [0.0] * (n + 1)
        for i, a in enumerate(corners):
            b = corners[i + 1] if i + 1 < len(corners) else corners[0] + n
            between = b - a - 3  # single knots between two triple ones
            ladder = [a, a] + [a + (b - a) * (j + 1) / (between + 1) for j in range(between)] + [b]
            for j, value in enumerate(ladder):  # knots a .. b-1
                index = a + j
                if index < n:
                    knots[index] = value
                else:
                    knots[index - n] = value - n
        knots[n] = knots[0] + n
        return knots

    def _knot(self, i):
        n = len(self.points)
        if not self.closed:
            return self.knots[i]
        return self.knots[i % n] + (self.knots[n] - self.knots[0]) * floor(i / n)

    def at(self, t):
        n, d = len(self.points), self.degree
        if self.closed:
            period = self.end - self.start
            t = self.start + (t - self.start) % period
            a = (d + 1) // 2
            span = bisect_right(self.knots, t, 0, n + 1) - 1
        else:
            t = min(max(t, self.start), self.end)
            a = 0
            span = min(bisect_right(self.knots, t) - 1, n - 1)
        values = [self.points[(span + a - d + j) % n] for j in range(d + 1)]
        for r in range(1, d + 1):
            for j in range(d, r - 1, -1):
                low, high = self._knot(j + span - d), self._knot(j + 1 + span - r)
                w = (t - low) / (high - low)
                values[j] = [(1 - w) * p + w * q for p, q in zip(values[j - 1], values[j])]
        return values[d]

    def _lengths(self, per_unit=24):
        if self._table is None:
            count = max(64, int((self.end - self.start) * per_unit))
            ts = [self.start + (self.end - self.start) * i / count for i in range(count + 1)]
            ts = sorted(set(ts + [k for k in self.knots if self.start <= k <= self.end]))
            if self.closed:
                ps = [self.at(t) for t in ts[:-1]] + [self.at(ts[0])]
            else:
                ps = [self.at(t) for t in ts]
            sums = [0.0]
            for p, q in zip(ps, ps[1:]):
                sums.append(sums[-1] + dist(p, q))
            self._table = ts, sums
        return self._table

    def length_to(self, t):
        """Arc length from the start of the domain, also beyond the period of a closed curve."""
        ts, sums = self._lengths()
        turns = 0
        if self.closed:
            period = self.end - self.start
            turns = floor((t - self.start) / period)
            t -= turns * period
        i = min(max(bisect_right(ts, t) - 1, 0), len(ts) - 2)
        w = (t - ts[i]) / (ts[i + 1] - ts[i])
        return turns * sums[-1] + (1 - w) * sums[i] + w * sums[i + 1]

    def parameter_at(self, length):
        ts, sums = self._lengths()
        turns = floor(length / sums[-1]) if self.closed else 0
        length -= turns * sums[-1]
        i = min(max(bisect_right(sums, length) - 1, 0), len(ts) - 2)
        w = (length - sums[i]) / (sums[i + 1] - sums[i])
        return (1 - w) * ts[i] + w * ts[i + 1] + turns * (self.end - self.start)

    def stretch_end(self, start, end):
        """`end`, a period later if the stretch passes the start of the curve."""
        return end + (self.end - self.start) if self.closed and end <= start else end

    def stretch_length(self, start, end):
        return self.length_to(self.stretch_end(start, end)) - self.length_to(start)

    def sample(self, count, start=None, end=None):
        """count + 1 points at equal fractions of the arc length of a stretch."""
        if start is None:
            start, end = self.start, self.end
        else:
            end = self.stretch_end(start, end)
        a, b = self.length_to(start), self.length_to(end)
        parameters = [start] + [self.parameter_at(a + (b - a) * i / count) for i in range(1, count)] + [end]
        return [self.at(t) for t in parameters]


def part_of(form, start, end):
    """The control points of an open curve between two of its inner knots, by inserting them to full multiplicity.

    With uniform knots the part has the default knots again.
    """
    d = form["degree"]
    curve = BSpline(form)
    knots, points = list(curve.knots), [list(p) for p in curve.points]
    for t in (start, end):
        for _ in range(d - knots.count(t)):
            span = bisect_right(knots, t) - 1
            inserted = []
            for i in range(span - d + 1, span + 1):
                width = knots[i + d] - knots[i]
                w = (t - knots[i]) / width if width else 1.0
                inserted.append([(1 - w) * p + w * q for p, q in zip(points[i - 1], points[i])])
            points[span - d + 1:span] = inserted
            knots.insert(span + 1, t)
    first = bisect_right(knots, start) - 1 - d
    last = bisect_right(knots, end) - 1 - d if end < curve.end else len(points) - 1
    return points[first:last + 1]
