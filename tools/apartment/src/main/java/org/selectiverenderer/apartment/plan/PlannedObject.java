package org.selectiverenderer.apartment.plan;

/**
 * An object's name and its place.
 *
 * @param number 1 for the first one of several that are alike
 */
public record PlannedObject(Room room, String object, int number, RoomPosition place) {

  /** Unique in the apartment: the object's name, with a number for all but the first. */
  public String name() {
    return number == 1 ? object : object + "_" + number;
  }
}
