package org.selectiverenderer.browser.nodes.bindable;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.browser.scene.EventCascade;

/** The binding stack of one kind of bindable node; the topmost node is bound (X3D 4.0, 7.2.2). */
final class BindingStack {
  private final List<BindableNode> stack = new ArrayList<>();

  Optional<BindableNode> top() {
    return stack.isEmpty() ? Optional.empty() : Optional.of(stack.get(stack.size() - 1));
  }

  /**
   * Moves a node to the top; first the node bound before is told that it is unbound, then the new
   * one that it is bound.
   */
  void bind(BindableNode node, EventCascade cascade) {
    Optional<BindableNode> before = top();
    if (before.isPresent() && before.get() == node) {
      return;
    }
    stack.remove(node);
    stack.add(node);
    before.ifPresent(old -> old.sendBound(false, cascade));
    node.sendBound(true, cascade);
  }

  /** Removes a node; if it was bound, it is told so, and then the node that is bound now. */
  void unbind(BindableNode node, EventCascade cascade) {
    boolean bound = top().filter(topmost -> topmost == node).isPresent();
    stack.remove(node);
    if (bound) {
      node.sendBound(false, cascade);
      top().ifPresent(next -> next.sendBound(true, cascade));
    }
  }

  /**
   * Removes the nodes that are not present any more, as if they were unbound; the node that is
   * bound then is told once.
   */
  void retain(Set<BindableNode> present, EventCascade cascade) {
    Optional<BindableNode> before = top();
    stack.removeIf(node -> !present.contains(node));
    if (before.isPresent() && !present.contains(before.get())) {
      before.get().sendBound(false, cascade);
      top().ifPresent(next -> next.sendBound(true, cascade));
    }
  }
}
