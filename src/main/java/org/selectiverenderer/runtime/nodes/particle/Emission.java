package org.selectiverenderer.runtime.nodes.particle;

import org.joml.Vector3d;

/** Chooses where a new particle begins and which way it goes (X3D 4.0, 40.3.2). */
@FunctionalInterface
interface Emission {
  /**
   * @param position receives the place, in the system's coordinates
   * @param direction receives the way, of unit length or 0
   */
  void emit(Chance chance, Vector3d position, Vector3d direction);
}
