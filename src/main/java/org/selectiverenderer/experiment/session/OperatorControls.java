package org.selectiverenderer.experiment.session;

import java.util.Map;
import java.util.Optional;

/**
 * What the experimenter asks for while a session runs. Set by the control window, read by whoever
 * runs the step; each request is in the journal at the moment it is made.
 */
public final class OperatorControls {
  private final SessionJournal journal;
  private volatile boolean paused;
  private volatile boolean aborted;
  private volatile boolean going;
  private volatile boolean resetting;
  private volatile boolean asking;
  private volatile String status = "";
  private volatile Optional<Runnable> question = Optional.empty();

  public OperatorControls(SessionJournal journal) {
    this.journal = journal;
  }

  /** Practice is over, as soon as whoever runs it looks. */
  public void goOn() {
    going = true;
    journal.tell("go-on", Map.of());
  }

  /** Where the head looks is straight ahead, as soon as whoever runs the step looks. */
  public void resetHeading() {
    resetting = true;
  }

  /** Whether the heading is to be reset; asked for since the last call. */
  public boolean takeResetHeading() {
    boolean asked = resetting;
    resetting = false;
    return asked;
  }

  /** Stops the clock and darkens the participant's picture, or goes on. */
  public void pause(boolean on) {
    paused = on;
    journal.tell(on ? "paused" : "continued", Map.of());
  }

  /**
   * Has somebody who can ask the experimenter whether the session is to end.
   *
   * @param ask asks; called by any thread, returns at once
   */
  public void questioner(Runnable ask) {
    question = Optional.of(ask);
  }

  /**
   * Somebody closes a window: the experimenter is asked whether the session is to end.
   *
   * @return whether there is somebody who asks
   */
  public boolean askAbort() {
    question.ifPresent(Runnable::run);
    return question.isPresent();
  }

  /** The experimenter is being asked something, or no more: the pointer is needed for that. */
  public void asking(boolean now) {
    asking = now;
  }

  public boolean asking() {
    return asking;
  }

  /** Ends the session. */
  public void abort() {
    aborted = true;
  }

  /** Writes something down; the journal has the time. */
  public void note(String text) {
    journal.tell("note", Map.of("text", text));
  }

  public boolean paused() {
    return paused;
  }

  public boolean aborted() {
    return aborted;
  }

  /** Whether to go on was asked for since the last call. */
  public boolean takeGoOn() {
    boolean asked = going;
    going = false;
    return asked;
  }

  /** Where the session is, for the control window. */
  public void status(String text) {
    status = text;
  }

  public String status() {
    return status;
  }
}
