// SPDX-License-Identifier: Apache-2.0
// The candidates of two meshes, or of one with itself, task by task.
export module abut.proximity.search;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.proximity.body;
import abut.trees.elements.element_pairs;

export namespace abut {

// How pairs of nodes are cut into tasks, and the lists that tasks fill. The number of tasks depends on the trees alone,
// so that results do not depend on threads. Kept from search to search, so that memory is.
class ElementSearch {
 public:
  // Fits both trees, so that what comes within reach of each other is a candidate. One mesh is given twice.
  void begin(ElementBody& a, ElementBody& b, Real reach, const Workers& workers);
  [[nodiscard]] std::size_t tasks() const { return cuts_.tasks(); }

  // Calls work(task, candidates) with few candidates at a time, so that they stay in the cache.
  template <class Work>
  void for_each_candidates(const ElementBody& a, const ElementBody& b, const Workers& workers, const Work& work) {
    visit(a, b, workers, candidates_, work);
  }
  template <class Work>
  void for_each_crossing_candidates(const ElementBody& a, const ElementBody& b, const Workers& workers,
                                    const Work& work) {
    visit(a, b, workers, crossing_candidates_, work);
  }

 private:
  template <class List, class Work>
  void visit(const ElementBody& a, const ElementBody& b, const Workers& workers, std::vector<List>& lists,
             const Work& work) {
    lists.resize(std::max(lists.size(), tasks()));
    workers.for_each(tasks(), [&](std::size_t task) {
      for (const NodePair& nodes : cuts_.of(pairs_.list(), task)) {
        lists[task].clear();
        append_candidates(a.tree(), b.tree(), nodes, lists[task]);
        work(task, std::as_const(lists[task]));
      }
    });
  }

  NodePairs pairs_;
  Cuts cuts_{0, 0};
  std::vector<Candidates> candidates_;
  std::vector<CrossingCandidates> crossing_candidates_;
};

}  // namespace abut
