package org.selectiverenderer.x3d.vrml1;

import java.util.List;
import java.util.function.Function;
import org.joml.Matrix4dc;
import org.jspecify.annotations.Nullable;

/**
 * A group whose children are being translated: the element that contains them, and the
 * transformations that count for the next one.
 */
final class TranslationScope {
  private static final String GROUP = "Group";

  private final TransformChain pending;
  private final TransformChain total;

  /**
   * The transformations since the container of the whole scope, which may itself be a Transform.
   */
  private final TransformChain within;

  private final LightGroups lights;
  private X3dElement container;

  /** The container of which the first {@link #unlit} children are known to be lit by nothing. */
  private @Nullable X3dElement asked;

  private int unlit;
  private X3dElement wrapper;
  private boolean own;
  private boolean moved;

  /** Creates the scope of an element without children. */
  TranslationScope(X3dElement container, Vrml1Values values, SharedElements shared) {
    this.container = container;
    this.wrapper = container;
    this.pending = new TransformChain(values);
    this.total = new TransformChain(values);
    this.within = new TransformChain(values);
    this.lights = new LightGroups(container, shared);
    this.own = container.name().equals(GROUP);
  }

  /** Returns the transformations since the start of the group. */
  TransformChain total() {
    return total;
  }

  /** Transforms what follows by a node of a type. */
  void transform(Vrml1Node node, String type) {
    pending.add(node, type);
    total.add(node, type);
    within.add(node, type);
    moved = true;
  }

  /** Transforms what follows as another scope, which does not save its transformations, has. */
  void transform(TransformChain other) {
    pending.append(other);
    total.append(other);
    within.append(other);
    moved |= !other.isEmpty();
  }

  /** Returns the element in which the next child belongs. */
  X3dElement target() {
    if (pending.isEmpty()) {
      return container;
    }
    if (own && container.children().isEmpty()) {
      // the group itself becomes the Transform
      container.rename("Transform");
      pending.set(container);
      pending.clear();
      within.clear();
      own = false;
      moved = false;
      return container;
    }
    if (moved) {
      wrapper = pending.transform();
      container.add(wrapper);
      moved = false;
    }
    return wrapper;
  }

  /**
   * Adds a light, which shines on what follows and not on what was before.
   *
   * @param transformed makes the same light with its location and direction transformed by a matrix
   */
  void addLight(X3dElement light, Function<Matrix4dc, X3dElement> transformed) {
    boolean becomesTransform = own && container.children().isEmpty();
    if (!becomesTransform && (!pending.isEmpty() || !isUnlit())) {
      X3dElement outer = lights.next(light.start());
      if (outer != null) {
        container = outer;
        pending.clear();
        pending.append(within);
      }
      moved = true; // the last Transform may have shapes that this light shall not reach
    }
    boolean first = isUnlit();
    if (!pending.isEmpty()) {
      container = target();
      pending.clear();
    } else if (!first) {
      X3dElement group = new X3dElement(GROUP, light.start(), light.start());
      container.add(group);
      container = group;
    }
    own = false;
    moved = false;
    container.add(light);
    lights.add(light, container, within, transformed);
  }

  /** Returns whether the container has no child that a light would shine on. */
  private boolean isUnlit() {
    List<X3dElement> children = container.children();
    if (container != asked) {
      asked = container;
      unlit = 0;
    }
    while (unlit < children.size() && !isLit(children.get(unlit))) {
      unlit++;
    }
    return unlit == children.size();
  }

  private static boolean isLight(X3dElement element) {
    return element.name().endsWith("Light");
  }

  private static boolean isLit(X3dElement element) {
    return switch (element.name()) {
      case "Viewpoint", "OrthoViewpoint", "Background", "Fog", "NavigationInfo", "WorldInfo" ->
          false;
      default -> !isLight(element);
    };
  }

  /** Returns a group, or its only child where that shows the same. */
  static X3dElement simplified(X3dElement group) {
    return group.plainGroup() && group.children().size() == 1 && !isLight(group.children().get(0))
        ? group.children().get(0)
        : group;
  }
}
