package org.selectiverenderer.study.session;

import java.util.Map;
import java.util.Optional;

/**
 * The experimenter's requests while a session runs: set by the control window, read by the thread
 * that runs the step, and logged in the journal when they are made.
 */
public final class ExperimenterControls {
  private final SessionJournal journal;
  private final boolean calibrates;
  private volatile boolean paused;
  private volatile boolean aborted;
  private volatile boolean going;
  private volatile boolean resetting;
  private volatile boolean asking;
  private volatile String status = "";
  private volatile String alarm = "";
  private volatile Optional<Runnable> question = Optional.empty();

  public ExperimenterControls(SessionJournal journal) {
    this(journal, false);
  }

  /**
   * @param calibrates whether another device, such as an eye tracker, records beside the session,
   *     so that its calibrations are marked
   */
  public ExperimenterControls(SessionJournal journal, boolean calibrates) {
    this.journal = journal;
    this.calibrates = calibrates;
  }

  /** Returns whether the experimenter can mark calibrations. */
  public boolean calibrates() {
    return calibrates;
  }

  /** Marks in the journal that another device, such as an eye tracker, has been calibrated. */
  public void calibrated() {
    if (calibrates) {
      journal.tell("calibration", Map.of("by", "experimenter"));
    }
  }

  /** Requests the end of the practice. */
  public void goOn() {
    going = true;
    journal.tell("go-on", Map.of());
  }

  /** Requests a boresight: the present heading of the head becomes straight ahead. */
  public void resetHeading() {
    resetting = true;
  }

  /** Returns whether a boresight was requested since the last call. */
  public boolean takeResetHeading() {
    boolean asked = resetting;
    resetting = false;
    return asked;
  }

  /**
   * Pauses the session, which stops the clock and darkens the participant's picture, or continues
   * it.
   */
  public void pause(boolean on) {
    paused = on;
    journal.tell(on ? "paused" : "continued", Map.of());
  }

  /**
   * Registers the dialog that asks the experimenter whether to end the session.
   *
   * @param ask opens the dialog; called by any thread, returns at once
   */
  public void questioner(Runnable ask) {
    question = Optional.of(ask);
  }

  /**
   * Asks the experimenter whether to end the session, as when a window is closed.
   *
   * @return whether a dialog is registered
   */
  public boolean askAbort() {
    question.ifPresent(Runnable::run);
    return question.isPresent();
  }

  /** Sets whether a dialog is open, for which the mouse pointer must be free. */
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

  /** Logs a note in the journal, with the time. */
  public void note(String text) {
    journal.tell("note", Map.of("text", text));
  }

  public boolean paused() {
    return paused;
  }

  public boolean aborted() {
    return aborted;
  }

  /** Returns whether the end of the practice was requested since the last call. */
  public boolean takeGoOn() {
    boolean asked = going;
    going = false;
    return asked;
  }

  /** Sets the state of the session that the control window shows. */
  public void status(String text) {
    status = text;
  }

  public String status() {
    return status;
  }

  /** Sets what is wrong now and needs the experimenter; empty where nothing is. */
  public void alarm(String text) {
    alarm = text;
  }

  public String alarm() {
    return alarm;
  }
}
