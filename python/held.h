#pragma once
#include <memory>
#include <mutex>
#include <shared_mutex>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/pybind11.h>

#include <ringwatch/body/body.h>

namespace ringwatch::python {

namespace py = pybind11;

/// A mesh as Python knows it: it never changes.
struct HeldMesh {
  std::shared_ptr<const Mesh> mesh;
  std::vector<std::string> notes;  // of its reader
};

/// A body as Python objects share it. Passes over the elements are allowed side by side, changes are not: Python's own
/// lock is given up in both.
struct HeldBody {
  template <class Materials>
  HeldBody(const Mesh& mesh, const Materials& materials, const BodyOptions& options) : body(mesh, materials, options) {}

  Body body;
  std::shared_mutex changes;
  std::vector<std::unique_ptr<Body::Workspace>> workspaces;  // that no pass uses now
  std::mutex workspaceTurn;
};

/// Scratch memory of a pass. It is kept from pass to pass: as large as the nodal arrays, it would cost a good part of
/// one.
class BorrowedWorkspace {
 public:
  explicit BorrowedWorkspace(HeldBody& held) : held_(held) {
    const std::lock_guard lock(held.workspaceTurn);
    if (!held.workspaces.empty()) {
      workspace_ = std::move(held.workspaces.back());
      held.workspaces.pop_back();
    } else {
      workspace_ = std::make_unique<Body::Workspace>();
    }
  }
  ~BorrowedWorkspace() {
    const std::lock_guard lock(held_.workspaceTurn);
    held_.workspaces.push_back(std::move(workspace_));
  }
  BorrowedWorkspace(const BorrowedWorkspace&) = delete;
  BorrowedWorkspace& operator=(const BorrowedWorkspace&) = delete;
  Body::Workspace& operator*() { return *workspace_; }

 private:
  HeldBody& held_;
  std::unique_ptr<Body::Workspace> workspace_;
};

/// Calls work() without Python's lock, with one that is taken after that has been given up, so that no thread waits
/// for one of them while it has the other.
template <class Lock, class Mutex, class Work>
auto unlocked(Mutex& mutex, const Work& work) {
  const py::gil_scoped_release release;
  const Lock lock(mutex);
  return work();
}
/// Reads the body.
template <class Work>
auto reading(HeldBody& held, const Work& work) {
  return unlocked<std::shared_lock<std::shared_mutex>>(held.changes, work);
}
/// Changes it.
template <class Work>
auto changing(HeldBody& held, const Work& work) {
  return unlocked<std::unique_lock<std::shared_mutex>>(held.changes, work);
}

/// "81 nodes, 160 tet4".
std::string meshText(const Mesh& mesh);

void bindMesh(py::module_& module);
void bindBody(py::module_& module);
void bindInspect(py::module_& module);
void bindMonitor(py::module_& module);
void bindTangentBracket(py::module_& module);

}  // namespace ringwatch::python
