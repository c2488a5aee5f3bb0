package org.selectiverenderer.apartment.plan;

/**
 * A row of the plan: an object's name and its position.
 *
 * @param number number of this copy, 1 for the first of several alike
 */
public record PlannedObject(Room room, String object, int number, RoomPosition place) {

  /**
   * Returns a name that is unique in the apartment: the object's name, with a number for all copies
   * but the first.
   */
  public String name() {
    return number == 1 ? object : object + "_" + number;
  }
}
