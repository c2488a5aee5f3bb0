package org.selectiverenderer.experiment.headlog;

import java.util.List;

/**
 * One frame of a session.
 *
 * @param t seconds since the session began
 * @param x of the middle between the eyes, in the world and in the scene's unit of length
 * @param y likewise
 * @param z likewise
 * @param yaw degrees about Y, positive to the left; yaw, pitch and roll compose in this order
 * @param pitch degrees about X, positive up
 * @param roll degrees about Z, positive to the left shoulder
 * @param moved whether head or viewer moved since the frame before
 * @param object in the middle of the view: by the DEF of its Switch, else of its Inline, else the
 *     nearest; empty when there is none
 * @param distance of its surface, in the scene's unit; NaN when there is none
 * @param version the choice that its Switch shows, -1 when no Switch holds it
 * @param cone objects in a cone about the middle, the one that fills most of it first
 * @param schemas active ones
 * @param frameMs milliseconds from the frame before to this one
 */
public record HeadSample(
    double t,
    double x,
    double y,
    double z,
    double yaw,
    double pitch,
    double roll,
    boolean moved,
    String object,
    double distance,
    int version,
    List<String> cone,
    List<String> schemas,
    double frameMs) {

  public HeadSample {
    cone = List.copyOf(cone);
    schemas = List.copyOf(schemas);
  }
}
