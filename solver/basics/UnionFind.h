// Disjoint sets of 0 .. n-1.
#pragma once

#include <numeric>
#include <utility>
#include <vector>

namespace bolster {

class UnionFind {
public:
    explicit UnionFind(int count)
        : m_parent(count)
    {
        std::iota(m_parent.begin(), m_parent.end(), 0);
    }

    int root(int i)
    {
        while (m_parent[i] != i)
            i = m_parent[i] = m_parent[m_parent[i]];
        return i;
    }
    /// The smaller root stays the root, so labels do not depend on the order of joining.
    void join(int a, int b)
    {
        a = root(a);
        b = root(b);
        if (a > b)
            std::swap(a, b);
        m_parent[b] = a;
    }
    /// A label 0 .. count-1 for each item, in order of first appearance.
    std::vector<int> labels(int* count = nullptr)
    {
        std::vector<int> label(m_parent.size(), -1);
        int next = 0;
        for (int i = 0; i < static_cast<int>(m_parent.size()); ++i) {
            const int r = root(i);
            if (label[r] < 0)
                label[r] = next++;
            label[i] = label[r];
        }
        if (count)
            *count = next;
        return label;
    }

private:
    std::vector<int> m_parent;
};

} // namespace bolster
