package org.selectiverenderer.apartment.building;

import org.selectiverenderer.apartment.plan.WallSide;

/**
 * An opening in a wall for a window or a door; a door's opening reaches the floor.
 *
 * @param middle x or z of its middle in world coordinates, metres
 * @param sill height of its lower edge above the floor, metres; 0 for a door
 */
record Opening(WallSide side, double middle, double width, double sill, double height) {

  static Opening door(WallSide side, double middle) {
    return new Opening(side, middle, 0.86, 0, 2.05);
  }

  boolean isDoor() {
    return sill == 0;
  }

  /** Returns its left edge for a viewer who faces the wall, in the wall's coordinates. */
  double left() {
    return side.across(middle) - width / 2;
  }

  double right() {
    return left() + width;
  }

  double top() {
    return sill + height;
  }
}
