package org.selectiverenderer.authoring.ratings;

import java.util.Optional;
import java.util.OptionalDouble;
import org.selectiverenderer.schema.ConsistencyType;

/**
 * The consistency of an object with a schema that is proposed from what participants looked at.
 *
 * @param object name of the object in the logs, the DEF of its Switch as a rule
 * @param rating mean rating from 1 to 6 that was taken into account; empty for none
 * @param degree of consistency, 0 to 1
 * @param low lower end of the degree's 90% interval
 * @param high upper end of that interval
 * @param type the type that follows; empty where the interval holds 1/2 or too few looked
 * @param evidence what the proposal rests on
 * @param versions number of versions that the scene has of the object; 0 if it is no Switch
 */
public record GazeProposal(
    String object,
    String schema,
    OptionalDouble rating,
    double degree,
    double low,
    double high,
    Optional<ConsistencyType> type,
    Evidence evidence,
    int versions) {

  /**
   * This is the evidence on which a proposal rests.
   *
   * @param participants number of those who had the object in view
   * @param inView seconds in which they had it in view
   * @param dwell seconds in which they looked at it
   * @param looks number of fixations, or of looks in logs without gaze data
   */
  public record Evidence(int participants, double inView, double dwell, int looks) {}

  /** Returns whether the proposal says something that can be written into the scene. */
  public boolean applicable() {
    return type.isPresent() && versions > 1;
  }

  /**
   * Returns the rating that shows the version which the degree asks for. In bands it is up to 3 for
   * an inconsistent object, above it for a consistent one, from 4 for degrees from 3/4.
   */
  double equivalentRating(RatingScale scale) {
    return switch (scale) {
      case BANDS -> degree < 0.75 ? 1 + 4 * degree : 8 * degree - 2;
      case LINEAR -> 1 + 5 * degree;
    };
  }
}
