package org.selectiverenderer.browser.nodes.bindable;

import java.util.ArrayList;
import java.util.Collections;
import java.util.EnumMap;
import java.util.IdentityHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.browser.nodes.group.GroupingNode;
import org.selectiverenderer.browser.nodes.group.InlineNode;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Node;

/**
 * The binding stacks of a scene for Viewpoint, NavigationInfo, Background and Fog nodes (X3D 4.0,
 * 7.2.2). Initially the first node of each kind in the file is bound; nodes in Inlines can be bound
 * later. {@link #update} follows nodes that enter or leave the scene, of which {@link
 * #structureChanged} tells: the instance tree observes every group anyway, of which a scene may
 * have a hundred thousand.
 */
public final class BindingStacks {
  /** The kinds of bindable nodes; each has a stack of its own. */
  private enum Kind {
    VIEWPOINT("X3DViewpointNode"),
    NAVIGATION_INFO("NavigationInfo"),
    BACKGROUND("X3DBackgroundNode"),
    FOG("Fog");

    private final String typeName;

    Kind(String typeName) {
      this.typeName = typeName;
    }

    static Kind of(BindableNode node) {
      for (Kind kind : values()) {
        if (node.type().is(kind.typeName)) {
          return kind;
        }
      }
      throw new IllegalArgumentException(node.type() + " is not a bindable node");
    }

    static Kind of(String name) {
      for (Kind kind : values()) {
        if (kind.typeName.equals(name) || kind.typeName.equals("X3D" + name + "Node")) {
          return kind;
        }
      }
      throw new IllegalArgumentException(name + " is not a kind of bindable node");
    }
  }

  private final Node root;
  private final Map<Kind, BindingStack> stacks = new EnumMap<>(Kind.class);
  private Set<BindableNode> present = Set.of();
  private boolean stale = true;

  /**
   * Binds the first node of each kind.
   *
   * @param root the scene's root group
   */
  public BindingStacks(Node root, EventCascade cascade) {
    this.root = root;
    for (Kind kind : Kind.values()) {
      stacks.put(kind, new BindingStack());
    }
    update(cascade);
    Walk own = new Walk(false);
    own.visit(root);
    for (BindableNode node : own.found) {
      if (stack(node).top().isEmpty()) {
        bind(node, cascade);
      }
    }
  }

  /**
   * Returns the bound node of a kind.
   *
   * @param kind {@code X3DViewpointNode} or {@code Viewpoint}, {@code NavigationInfo}, {@code
   *     X3DBackgroundNode} or {@code Background}, {@code Fog}
   * @throws IllegalArgumentException for another name
   */
  public Optional<Node> bound(String kind) {
    return stacks.get(Kind.of(kind)).top().map(Node.class::cast);
  }

  /**
   * Returns all nodes of a kind in the scene, bound or not, Inlines included, in document order.
   */
  public List<Node> all(String kind) {
    Kind wanted = Kind.of(kind);
    return present.stream().filter(n -> Kind.of(n) == wanted).map(Node.class::cast).toList();
  }

  /** Binds a bindable node of the scene; ignores any other node. */
  public void bind(Node node, EventCascade cascade) {
    if (node instanceof BindableNode bindable) {
      cascade.send(bindable, bindable.setBind(), true);
    }
  }

  void setBind(BindableNode node, boolean bind, EventCascade cascade) {
    if (bind) {
      stack(node).bind(node, cascade);
    } else {
      stack(node).unbind(node, cascade);
    }
  }

  private BindingStack stack(BindableNode node) {
    return stacks.get(Kind.of(node));
  }

  /**
   * Follows changes of the scene: added nodes can be bound, removed nodes are unbound. Costs
   * nothing while no group's children change.
   */
  public void update(EventCascade cascade) {
    if (!stale) {
      return;
    }
    stale = false;
    Walk walk = new Walk(true);
    walk.visit(root);
    for (BindableNode node : walk.found) {
      node.join(this);
    }
    Set<BindableNode> before = present;
    present = walk.found;
    before.stream().filter(node -> !present.contains(node)).forEach(BindableNode::leave);
    stacks.values().forEach(stack -> stack.retain(present, cascade));
  }

  /** Notes that a group of the scene has other children. */
  public void structureChanged() {
    stale = true;
  }

  /** Releases the scene: its nodes no longer react to {@code set_bind}. */
  public void close() {
    present.forEach(BindableNode::leave);
  }

  /** Finds bindable nodes in document order, each once. */
  private static final class Walk {
    private final boolean intoInlines;
    private final Set<BindableNode> found = new LinkedHashSet<>();
    private final Set<GroupingNode> groups = Collections.newSetFromMap(new IdentityHashMap<>());

    Walk(boolean intoInlines) {
      this.intoInlines = intoInlines;
    }

    void visit(Node start) {
      List<Entry> open = new ArrayList<>(List.of(new Entry(start, false)));
      while (!open.isEmpty()) {
        Entry entry = open.remove(open.size() - 1);
        Node node = entry.node();
        if (node instanceof BindableNode bindable) {
          if (bindable instanceof ViewpointNode viewpoint && intoInlines) {
            if (entry.inlined() && viewpoint.isUnnamedOverview()) {
              continue;
            }
            found.add(bindable);
            viewpoint.navigationInfo().ifPresent(found::add);
          } else {
            found.add(bindable);
          }
        } else if (node instanceof GroupingNode group
            && groups.add(group)
            && (intoInlines || !(group instanceof InlineNode))) {
          boolean inlined = entry.inlined() || group instanceof InlineNode;
          List<Node> children = group.children();
          for (int i = children.size() - 1; i >= 0; i--) {
            open.add(new Entry(children.get(i), inlined));
          }
        }
      }
    }

    private record Entry(Node node, boolean inlined) {}
  }
}
