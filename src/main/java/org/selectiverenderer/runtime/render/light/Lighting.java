package org.selectiverenderer.runtime.render.light;

import java.util.ArrayList;
import java.util.List;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.runtime.instance.Light;
import org.selectiverenderer.runtime.instance.LightInstance;
import org.selectiverenderer.runtime.instance.ShapeInstance;

/**
 * How a shape is lit. Good as long as the shape and those of its lights that have a place stay as
 * they were, unless it was made for a shape of which that is not expected.
 */
public final class Lighting {
  private final List<LightInstance> scope;
  private final List<LightInstance> reaching;
  private final boolean vertices;
  private final @Nullable Matrix4dc place;
  private final List<Placed> placed;
  private final @Nullable Unsteady unsteady;

  /** A light as it was. */
  private record Placed(LightInstance instance, Light light, boolean on, Matrix4dc world) {
    static Placed of(LightInstance instance) {
      return new Placed(instance, instance.light(), instance.on(), new Matrix4d(instance.world()));
    }

    /** Whether it reaches what it reached. */
    boolean stays() {
      return instance.light() == light && instance.world().equals(world, 0);
    }
  }

  /**
   * What moves: its light is by vertex whenever that is good enough where things are.
   *
   * @param longest edge of the mesh, in its own coordinates
   */
  record Unsteady(double longest, double tolerance) {
    boolean fine(ShapeInstance shape, List<LightInstance> lights) {
      double length = longest * Fineness.scale(shape.world());
      return new Reach(shape.bounds()).departure(lights, length) <= tolerance;
    }
  }

  /**
   * @param scope lights whose scope the shape lies in
   * @param reaching those of them that reach it
   * @param lit whether lights count at all
   * @param vertices whether light at the vertices of what is drawn is as good as at the pixels
   * @param unsteady null for what stays where it is
   */
  Lighting(
      ShapeInstance shape,
      List<LightInstance> scope,
      List<LightInstance> reaching,
      boolean lit,
      boolean vertices,
      @Nullable Unsteady unsteady) {
    this.scope = scope;
    this.reaching = reaching;
    this.vertices = vertices;
    this.unsteady = unsteady;
    List<Placed> lights = new ArrayList<>();
    for (LightInstance light : scope) {
      if (lit && light.light().kind() != Light.Kind.DIRECTIONAL && unsteady == null) {
        lights.add(Placed.of(light));
      }
    }
    placed = List.copyOf(lights);
    place = lights.isEmpty() ? null : new Matrix4d(shape.world());
  }

  /** The lights whose scope the shape lies in. */
  public List<LightInstance> scope() {
    return scope;
  }

  /** Those of them that can reach it; of a shape that moves all. */
  public List<LightInstance> reaching() {
    return reaching;
  }

  /**
   * Those that can reach it where the shape is now, if there would else be too many.
   *
   * @param most how many are not too many
   */
  public List<LightInstance> reaching(ShapeInstance shape, int most) {
    return unsteady == null || reaching.size() <= most
        ? reaching
        : new Reach(shape.bounds()).of(reaching);
  }

  /** Whether it need not be made anew for where the shape and its lights are now. */
  public boolean current(ShapeInstance shape) {
    if (place == null) {
      return true;
    }
    for (int i = 0; i < placed.size(); i++) {
      Placed light = placed.get(i);
      // By pixel is good whichever lights are on.
      if (!light.stays() || (vertices && light.on() != light.instance().on())) {
        return false;
      }
    }
    return stands(shape);
  }

  /** Whether the shape stands where it was made for. */
  public boolean stands(ShapeInstance shape) {
    return place == null || shape.world().equals(place, 0);
  }

  /** Whether light at the vertices is as good as at the pixels, where the shape is now. */
  public boolean byVertex(ShapeInstance shape) {
    return vertices && (unsteady == null || unsteady.fine(shape, scope));
  }

  /** Whether that stays so as long as this is current. */
  public boolean settled() {
    return unsteady == null;
  }
}
