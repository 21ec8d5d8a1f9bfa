#pragma once
#include <mpi.h>

namespace ringwatch::test {

/// A communicator of some ranks of the world; null on the others.
class Some {
 public:
  explicit Some(int count) {
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_split(MPI_COMM_WORLD, rank < count ? 0 : MPI_UNDEFINED, rank, &communicator_);
  }
  ~Some() {
    if (communicator_ != MPI_COMM_NULL) MPI_Comm_free(&communicator_);
  }
  Some(const Some&) = delete;
  Some& operator=(const Some&) = delete;
  bool has() const { return communicator_ != MPI_COMM_NULL; }
  MPI_Comm get() const { return communicator_; }

 private:
  MPI_Comm communicator_ = MPI_COMM_NULL;
};

inline int worldSize() {
  int size = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  return size;
}

}  // namespace ringwatch::test
