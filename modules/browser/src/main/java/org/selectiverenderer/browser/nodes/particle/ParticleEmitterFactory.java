package org.selectiverenderer.browser.nodes.particle;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.joml.Vector3d;
import org.selectiverenderer.browser.scene.Node;

/** Makes the particle emitters of X3D 4.0, 40.4, from the present fields of emitter nodes. */
final class ParticleEmitterFactory {
  private ParticleEmitterFactory() {}

  /**
   * Makes the emitter of a node; empty if the node has no geometry to emit from.
   *
   * @param meshes the meshes of geometry nodes
   */
  static Optional<ParticleEmitter> of(Node emitter, SurfaceMeshCache meshes) {
    return switch (emitter.type().name()) {
      case "PointEmitter" -> Optional.of(point(emitter));
      case "ConeEmitter" -> Optional.of(cone(emitter));
      case "ExplosionEmitter" -> Optional.of(explosion(emitter));
      case "PolylineEmitter" -> polyline(emitter);
      case "SurfaceEmitter" -> surface(emitter, meshes);
      case "VolumeEmitter" -> volume(emitter, meshes);
      default -> Optional.empty();
    };
  }

  static Vector3d vector(Node node, String field) {
    float[] v = node.floats(field);
    return new Vector3d(v[0], v[1], v[2]);
  }

  /** Writes the field {@code direction}, or a random direction if it is 0 0 0. */
  private static void towards(Vector3d given, ParticleRandom chance, Vector3d direction) {
    if (given.lengthSquared() > 0) {
      direction.set(given).normalize();
    } else {
      direction.set(chance.direction());
    }
  }

  private static ParticleEmitter point(Node node) {
    Vector3d from = vector(node, "position");
    Vector3d to = vector(node, "direction");
    return (chance, position, direction) -> {
      position.set(from);
      towards(to, chance, direction);
    };
  }

  private static ParticleEmitter cone(Node node) {
    Vector3d from = vector(node, "position");
    Vector3d to = vector(node, "direction");
    double angle = node.number("angle");
    return (chance, position, direction) -> {
      position.set(from);
      towards(to, chance, direction);
      direction.set(chance.cone(new Vector3d(direction), angle));
    };
  }

  private static ParticleEmitter explosion(Node node) {
    Vector3d from = vector(node, "position");
    return (chance, position, direction) -> {
      position.set(from);
      direction.set(chance.direction());
    };
  }

  /** Makes an emitter with positions uniform along lines. */
  private static Optional<ParticleEmitter> polyline(Node node) {
    Node coord = node.node("coord");
    if (coord == null || !coord.type().name().equals("Coordinate")) {
      return Optional.empty();
    }
    float[] points = coord.floats("point");
    int[] index = node.ints("coordIndex");
    List<Vector3d> ends = new ArrayList<>();
    List<Double> upTo = new ArrayList<>();
    double length = 0;
    for (int i = 0; i + 1 < index.length; i++) {
      int a = index[i];
      int b = index[i + 1];
      if (a >= 0 && b >= 0 && a < points.length / 3 && b < points.length / 3) {
        Vector3d from = new Vector3d(points[3 * a], points[3 * a + 1], points[3 * a + 2]);
        Vector3d to = new Vector3d(points[3 * b], points[3 * b + 1], points[3 * b + 2]);
        double part = from.distance(to);
        if (part > 0 && Double.isFinite(part)) {
          length += part;
          upTo.add(length);
          ends.add(from);
          ends.add(to);
        }
      }
    }
    if (ends.isEmpty()) {
      return Optional.empty();
    }
    double[] sums = upTo.stream().mapToDouble(Double::doubleValue).toArray();
    Vector3d to = vector(node, "direction");
    return Optional.of(
        (chance, position, direction) -> {
          double at = chance.part() * sums[sums.length - 1];
          int line = SurfacePointSampler.find(sums, at);
          ends.get(2 * line).lerp(ends.get(2 * line + 1), chance.part(), position);
          towards(to, chance, direction);
        });
  }

  private static Optional<ParticleEmitter> surface(Node node, SurfaceMeshCache meshes) {
    return meshes.surface(node.node("surface")).map(points -> points::pick);
  }

  private static Optional<ParticleEmitter> volume(Node node, SurfaceMeshCache meshes) {
    Node coord = node.node("coord");
    if (coord == null || !coord.type().name().equals("Coordinate")) {
      return Optional.empty();
    }
    Vector3d to = vector(node, "direction");
    boolean internal = node.bool("internal");
    return meshes
        .surface(coord.floats("point"), node.ints("coordIndex"))
        .map(
            points ->
                (chance, position, direction) -> {
                  if (internal) {
                    points.pickInside(chance, position);
                  } else {
                    points.pick(chance, position, direction);
                  }
                  towards(to, chance, direction);
                });
  }
}
