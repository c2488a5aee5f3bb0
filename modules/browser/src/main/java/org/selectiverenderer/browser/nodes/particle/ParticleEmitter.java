package org.selectiverenderer.browser.nodes.particle;

import org.joml.Vector3d;

/** Chooses the initial position and direction of a new particle (X3D 4.0, 40.3.2). */
@FunctionalInterface
interface ParticleEmitter {
  /**
   * @param position receives the position, in the system's coordinates
   * @param direction receives the direction, of unit length or 0
   */
  void emit(ParticleRandom chance, Vector3d position, Vector3d direction);
}
