package org.selectiverenderer.apartment.plan;

/** An object's name and its place. */
public record Placement(Room room, String object, Place place) {}
