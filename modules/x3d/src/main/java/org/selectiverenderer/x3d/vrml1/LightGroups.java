package org.selectiverenderer.x3d.vrml1;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.function.Function;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.jspecify.annotations.Nullable;

/**
 * The groups within which the lights of one scope illuminate what follows them.
 *
 * <p>A light of X3D illuminates its siblings and what these contain, so a light after a shape
 * begins a group within the last one. Every eighth time, the group begins further outside and
 * repeats the lights that do not illuminate it there, every 64th time still further outside, and so
 * on, as the digits of a counter return to zero. The depth grows by at most 7 for each digit, and n
 * lights are repeated n log n times. The last group repeats no transformations: the lights that it
 * repeats are transformed themselves, since a Transform would keep their light within.
 */
final class LightGroups {
  private static final int BASE = 8;

  /** A light with the matrix of the transformations since the scope began; null if none. */
  private static final class Light {
    final X3dElement element;
    final @Nullable Matrix4d matrix;
    final Function<Matrix4dc, X3dElement> transformed;
    @Nullable X3dElement repeated;

    Light(
        X3dElement element,
        @Nullable Matrix4d matrix,
        Function<Matrix4dc, X3dElement> transformed) {
      this.element = element;
      this.matrix = matrix;
      this.transformed = transformed;
    }

    X3dElement repeat(SharedElements shared, int at) {
      if (repeated == null && matrix != null) {
        repeated = transformed.apply(matrix);
        return repeated;
      }
      return shared.use(repeated == null ? element : repeated, at);
    }
  }

  /** A group without transformations, and how many of the lights illuminate all that is in it. */
  private static final class Outer {
    final X3dElement group;
    final int number;
    int lights;

    Outer(X3dElement group, int number, int lights) {
      this.group = group;
      this.number = number;
      this.lights = lights;
    }
  }

  private final SharedElements shared;
  private final List<Light> lights = new ArrayList<>(0);
  private final Deque<Outer> outer = new ArrayDeque<>(1);
  private int count;

  /** Creates the groups of a scope, of which the outermost is its element. */
  LightGroups(X3dElement container, SharedElements shared) {
    this.shared = shared;
    outer.push(new Outer(container, 0, 0));
  }

  /**
   * Counts a further group for a light. Returns the element in which it begins instead of within
   * the last one, which repeats the earlier lights and is without transformations; null if it
   * begins within the last one.
   *
   * @param at the offset of the light
   */
  @Nullable X3dElement next(int at) {
    int number = count++;
    if (number == 0 || number % BASE != 0) {
      return null;
    }
    int step = BASE;
    while (number / step % BASE == 0) {
      step *= BASE;
    }
    while (outer.element().number > number - step) {
      outer.pop();
    }
    Outer parent = outer.element();
    X3dElement group = new X3dElement("Group", at, at);
    for (Light light : lights.subList(parent.lights, lights.size())) {
      group.add(light.repeat(shared, at));
    }
    parent.group.add(group);
    outer.push(new Outer(group, number, lights.size()));
    return group;
  }

  /**
   * Records a light.
   *
   * @param container the element that contains it
   * @param before the transformations since the scope began
   * @param transformed makes the same light with its location and direction transformed by a matrix
   */
  void add(
      X3dElement light,
      X3dElement container,
      TransformChain before,
      Function<Matrix4dc, X3dElement> transformed) {
    Matrix4d matrix = before.isEmpty() ? null : new Matrix4d(before.matrix());
    lights.add(new Light(light.original(), matrix, transformed));
    Outer last = outer.element();
    if (container == last.group) {
      last.lights = lights.size();
    }
  }
}
