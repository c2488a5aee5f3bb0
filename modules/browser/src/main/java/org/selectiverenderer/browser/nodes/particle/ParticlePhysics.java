package org.selectiverenderer.browser.nodes.particle;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.joml.Vector3d;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.geometry.bvh.MeshBvh;

/**
 * The physics models of a particle system (X3D 4.0, 40.2.2): forces, wind, and surfaces that
 * particles bounce off. Forces need particles with a mass, wind also with a surface area.
 */
final class ParticlePhysics {
  private final List<Node> forces = new ArrayList<>();
  private final List<Node> winds = new ArrayList<>();
  private final List<MeshBvh> bounds = new ArrayList<>();
  private final Vector3d acceleration = new Vector3d();
  private final double mass;
  private final double area;

  ParticlePhysics(List<Node> models, Node emitter, SurfaceMeshCache meshes) {
    mass = emitter.number("mass");
    area = emitter.number("surfaceArea");
    for (Node model : models) {
      if (model.type().field("enabled").isPresent() && !model.bool("enabled")) {
        continue;
      }
      switch (model.type().name()) {
        case "ForcePhysicsModel" -> forces.add(model);
        case "WindPhysicsModel" -> winds.add(model);
        case "BoundedPhysicsModel" ->
            meshes.surface(model.node("geometry")).ifPresent(found -> bounds.add(found.tree()));
        default -> {} // Unknown type, reported at loading.
      }
    }
    addForces();
  }

  private void addForces() {
    for (Node force : forces) {
      if (mass > 0) {
        acceleration.fma(1.0 / mass, ParticleEmitterFactory.vector(force, "force"));
      }
    }
  }

  /** Applies forces and wind to a velocity for one step. */
  void accelerate(Vector3d velocity, double seconds, ParticleRandom chance) {
    velocity.fma(seconds, acceleration);
    if (!(mass > 0) || !(area > 0)) {
      return;
    }
    for (Node wind : winds) {
      double speed = chance.around(wind.number("speed"), wind.number("gustiness"));
      // 40.4.13: pressure = 10 ^ (2 log speed) * 0.64615, in newtons per square metre.
      double pressure = speed * speed * 0.64615;
      Vector3d way = ParticleEmitterFactory.vector(wind, "direction");
      way = way.lengthSquared() > 0 ? way.normalize() : chance.direction();
      double turbulence = wind.number("turbulence");
      way = turbulence > 0 ? chance.cone(way, Math.PI * turbulence) : way;
      velocity.fma(seconds * pressure * area / mass, way);
    }
  }

  /** Moves a particle by one step and reflects its velocity where it hits a surface. */
  void move(Vector3d position, Vector3d velocity, double seconds) {
    for (MeshBvh bound : bounds) {
      if (velocity.lengthSquared() == 0) {
        break;
      }
      Optional<MeshBvh.MeshHit> hit =
          bound.nearest(position, velocity, seconds, MeshBvh.Sides.BOTH);
      if (hit.isPresent()) {
        int triangle = hit.get().triangle();
        Vector3d a = bound.corner(triangle, 0, new Vector3d());
        Vector3d b = bound.corner(triangle, 1, new Vector3d()).sub(a);
        Vector3d c = bound.corner(triangle, 2, new Vector3d()).sub(a);
        Vector3d normal = b.cross(c).normalize();
        position.fma(hit.get().distance() * 0.999, velocity);
        velocity.reflect(normal);
        return;
      }
    }
    position.fma(seconds, velocity);
  }
}
