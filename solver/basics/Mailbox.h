// Holds one item for another thread: newer replaces older, nobody waits to put.
#pragma once

#include <condition_variable>
#include <mutex>
#include <optional>
#include <stop_token>
#include <utility>

namespace bolster {

template <class T>
class Mailbox {
public:
    /// Returns whether it was empty, which is when the reader has to be woken.
    bool put(T item)
    {
        bool wasEmpty = false;
        {
            const std::lock_guard lock(m_mutex);
            wasEmpty = !m_item;
            m_item = std::move(item);
        }
        m_filled.notify_one();
        return wasEmpty;
    }

    std::optional<T> take()
    {
        const std::lock_guard lock(m_mutex);
        return std::exchange(m_item, std::nullopt);
    }

    bool full() const
    {
        const std::lock_guard lock(m_mutex);
        return m_item.has_value();
    }

    /// Waits for an item. False when stopped instead.
    bool wait(std::stop_token stop)
    {
        std::unique_lock lock(m_mutex);
        return m_filled.wait(lock, stop, [this] { return m_item.has_value(); });
    }

private:
    mutable std::mutex m_mutex;
    std::condition_variable_any m_filled;
    std::optional<T> m_item;
};

} // namespace bolster
