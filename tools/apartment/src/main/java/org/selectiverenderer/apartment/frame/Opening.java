package org.selectiverenderer.apartment.frame;

import org.selectiverenderer.apartment.plan.Side;

/**
 * A hole in a wall; a door's reaches the floor.
 *
 * @param middle the world's x or z of its middle
 * @param sill height of its lower end above the floor, metres; 0 for a door
 */
record Opening(Side side, double middle, double width, double sill, double height) {

  static Opening door(Side side, double middle) {
    return new Opening(side, middle, 0.86, 0, 2.05);
  }

  boolean isDoor() {
    return sill == 0;
  }

  /** Its left end as one looks at the wall, in the wall's frame. */
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
