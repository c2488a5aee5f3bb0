package org.selectiverenderer.app.studies;

import java.util.Optional;
import org.selectiverenderer.study.session.ParticipantIds;
import org.selectiverenderer.study.session.SessionFolder;
import org.selectiverenderer.study.session.StudyStatus;

/**
 * What becomes of a participant's id and a session's number, told before the command is started.
 * The command checks the same again.
 *
 * @param other the id that the typed one resembles; empty for none
 */
public record ParticipantCheck(Answer answer, String other) {
  /** What can be done with an id. */
  public enum Answer {
    /** Nothing is typed. */
    EMPTY,
    /** It has other signs than letters and digits. */
    INVALID,
    /** A new participant. */
    NEW,
    /** A known participant, whose session of this number has not begun. */
    KNOWN,
    /** New, but easily confused with {@link #other}: the experimenter has to confirm it. */
    ALIKE,
    /** It differs from {@link #other} in capitals only, and cannot be used. */
    SAME_FOLDER,
    /** The session has begun, and can be resumed. */
    BEGUN,
    /** The session is running now. */
    RUNNING,
    /** The session is over; another number begins a new one. */
    OVER
  }

  /** Checks an id and a number against a study's state. */
  public static ParticipantCheck of(StudyOverview study, String id, int session) {
    if (id.isEmpty()) {
      return new ParticipantCheck(Answer.EMPTY, "");
    }
    if (!id.matches(SessionFolder.LABEL)) {
      return new ParticipantCheck(Answer.INVALID, "");
    }
    ParticipantIds ids = study.ids();
    if (!ids.has(id)) {
      Optional<String> folder = ids.sameFolder(id);
      if (folder.isPresent()) {
        return new ParticipantCheck(Answer.SAME_FOLDER, folder.get());
      }
      return ids.alike(id)
          .map(other -> new ParticipantCheck(Answer.ALIKE, other))
          .orElse(new ParticipantCheck(Answer.NEW, ""));
    }
    if (study.running(id, session)) {
      return new ParticipantCheck(Answer.RUNNING, "");
    }
    Optional<StudyStatus.Row> row =
        study.status().sessions().stream()
            .filter(each -> each.participant().equals(id) && each.session() == session)
            .findFirst();
    return new ParticipantCheck(
        row.map(each -> resumable(each.state()) ? Answer.BEGUN : Answer.OVER).orElse(Answer.KNOWN),
        "");
  }

  /** Returns whether a session of a state can be resumed. */
  public static boolean resumable(StudyStatus.State state) {
    return state == StudyStatus.State.ABORTED || state == StudyStatus.State.OPEN;
  }

  /** Returns whether a session can be started or resumed, at the latest after a confirmation. */
  public boolean possible() {
    return switch (answer) {
      case NEW, KNOWN, ALIKE, BEGUN -> true;
      case EMPTY, INVALID, SAME_FOLDER, RUNNING, OVER -> false;
    };
  }
}
