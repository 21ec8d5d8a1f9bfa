#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <ringwatch/distributed/ranks.h>

namespace ringwatch {

/// What came from all ranks, those of rank 0 first.
template <class T>
struct Received {
  std::vector<T> values;
  std::vector<std::size_t> begin;  // [rank], and at the end their number
  std::span<const T> of(int rank) const {
    const auto r = static_cast<std::size_t>(rank);
    return {values.data() + begin[r], begin[r + 1] - begin[r]};
  }
};

namespace detail {
/// A number of values as MPI counts them.
inline int messageCount(std::size_t count) {
  if (count > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    throw std::length_error("more values to exchange with other ranks than a message can count; use more ranks");
  return static_cast<int>(count);
}
}  // namespace detail

/// Sends to[rank] to every rank; each is given back empty. Values are copied byte by byte. Throws std::length_error, on
/// one rank alone, where it has more than 2³¹ - 1 of them, which ends a program. Collective.
template <class T>
Received<T> exchange(Ranks& ranks, std::vector<std::vector<T>>& to) {
  static_assert(std::is_trivially_copyable_v<T>);
  const auto size = static_cast<std::size_t>(ranks.size());
  std::vector<int> counts(size), starts(size), countsIn(size), startsIn(size);
  std::size_t total = 0;
  for (std::size_t r = 0; r < size; ++r) {
    starts[r] = detail::messageCount(total);
    total += to[r].size();
    counts[r] = detail::messageCount(to[r].size());
  }
  std::vector<T> sent;
  sent.reserve(total);
  for (std::vector<T>& part : to) {
    sent.insert(sent.end(), part.begin(), part.end());
    part = {};
  }
  MPI_Alltoall(counts.data(), 1, MPI_INT, countsIn.data(), 1, MPI_INT, ranks.communicator());
  Received<T> received;
  received.begin.push_back(0);
  for (std::size_t r = 0; r < size; ++r) {
    startsIn[r] = detail::messageCount(received.begin.back());
    received.begin.push_back(received.begin.back() + static_cast<std::size_t>(countsIn[r]));
  }
  received.values.resize(received.begin.back());
  MPI_Datatype type = MPI_DATATYPE_NULL;
  MPI_Type_contiguous(static_cast<int>(sizeof(T)), MPI_BYTE, &type);
  MPI_Type_commit(&type);
  MPI_Alltoallv(sent.data(), counts.data(), starts.data(), type, received.values.data(), countsIn.data(),
                startsIn.data(), type, ranks.communicator());
  MPI_Type_free(&type);
  return received;
}

/// Asks home(question) for the answer to each question, by answer(question) there. Collective.
template <class Answer, class Question, class Home, class Reply>
std::vector<Answer> ask(Ranks& ranks, std::span<const Question> questions, const Home& home, const Reply& reply) {
  const auto size = static_cast<std::size_t>(ranks.size());
  std::vector<std::vector<Question>> to(size);
  for (const Question& question : questions) to[static_cast<std::size_t>(home(question))].push_back(question);
  const Received<Question> asked = exchange(ranks, to);
  std::vector<std::vector<Answer>> back(size);
  for (int r = 0; r < ranks.size(); ++r)
    for (const Question& question : asked.of(r)) back[static_cast<std::size_t>(r)].push_back(reply(question));
  const Received<Answer> answered = exchange(ranks, back);
  std::vector<std::size_t> next(answered.begin.begin(), answered.begin.end() - 1);
  std::vector<Answer> answers;
  answers.reserve(questions.size());
  for (const Question& question : questions)
    answers.push_back(answered.values[next[static_cast<std::size_t>(home(question))]++]);
  return answers;
}

/// Every rank's values, those of rank 0 first, on all of them. Throws as exchange(). Collective.
template <class T>
std::vector<T> gatherAll(Ranks& ranks, const std::vector<T>& own) {
  std::vector<std::vector<T>> to(static_cast<std::size_t>(ranks.size()), own);
  return exchange(ranks, to).values;
}

/// The sum of the numbers of the ranks before this one. Collective.
inline std::int64_t sumBefore(Ranks& ranks, std::int64_t own) {
  std::int64_t sum = 0;
  MPI_Exscan(&own, &sum, 1, MPI_INT64_T, MPI_SUM, ranks.communicator());
  return ranks.rank() == 0 ? 0 : sum;
}

/// The sum of the numbers of all ranks. Collective.
inline std::int64_t sumOver(Ranks& ranks, std::int64_t own) {
  std::int64_t sum = 0;
  MPI_Allreduce(&own, &sum, 1, MPI_INT64_T, MPI_SUM, ranks.communicator());
  return sum;
}

/// Throws InputError on all ranks, with the text of the rank whose `order` is the least; does nothing where no rank has
/// an order below noFault. text is called on that rank alone. Collective.
inline constexpr std::int64_t noFault = std::numeric_limits<std::int64_t>::max();
void throwFirst(Ranks& ranks, std::int64_t order, const std::function<std::string()>& text);

}  // namespace ringwatch
