package org.selectiverenderer.app.studies;

import java.util.Optional;

/**
 * The session that the experimenter wants.
 *
 * @param participant id of the participant
 * @param session number of the session, from 1
 * @param somebodyNew whether the experimenter has confirmed an id that resembles another one
 * @param resume whether to continue the session
 * @param language one of the study's languages, for a participant without sessions; empty for the
 *     first
 * @param options how it is shown
 */
public record SessionRequest(
    String participant,
    int session,
    boolean somebodyNew,
    boolean resume,
    Optional<String> language,
    Options options) {

  /**
   * Options of a session.
   *
   * @param view whether a window of the experimenter shows the participant's picture
   * @param withoutTracker whether to do without the study's tracker
   * @param showCondition whether the experimenter sees the condition of a blind study
   * @param unattended whether a simulated participant takes part, for a test
   */
  public record Options(
      boolean view, boolean withoutTracker, boolean showCondition, boolean unattended) {
    /** As the command without options. */
    public static final Options USUAL = new Options(false, false, false, false);
  }
}
