package org.selectiverenderer.browser.nodes.particle;

import org.joml.Vector3d;

/** The living particles: one array per property, the youngest last. */
final class ParticlePool {
  final Vector3d[] positions;
  final Vector3d[] velocities;
  final double[] ages;
  final double[] lifetimes;
  private int count;

  ParticlePool(int most) {
    positions = new Vector3d[most];
    velocities = new Vector3d[most];
    ages = new double[most];
    lifetimes = new double[most];
  }

  int count() {
    return count;
  }

  boolean full() {
    return count == positions.length;
  }

  void add(Vector3d position, Vector3d velocity, double age, double lifetime) {
    positions[count] = position;
    velocities[count] = velocity;
    ages[count] = age;
    lifetimes[count++] = lifetime;
  }

  void clear() {
    count = 0;
  }

  /** Ages and moves all particles and removes the expired ones. */
  void step(double seconds, ParticlePhysics physics, ParticleRandom chance) {
    int kept = 0;
    for (int i = 0; i < count; i++) {
      double age = ages[i] + seconds;
      if (age >= lifetimes[i]) {
        continue;
      }
      physics.accelerate(velocities[i], seconds, chance);
      physics.move(positions[i], velocities[i], seconds);
      positions[kept] = positions[i];
      velocities[kept] = velocities[i];
      lifetimes[kept] = lifetimes[i];
      ages[kept++] = age;
    }
    count = kept;
  }
}
