package org.selectiverenderer.study.session;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import org.selectiverenderer.base.decimal.Pluralizer;
import org.selectiverenderer.base.markup.ControlCharacterEscaper;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.formats.json.JsonWriter;
import org.selectiverenderer.study.definition.SessionFlag;
import org.selectiverenderer.study.design.StudyGroup;

/**
 * The progress of a study: the state of each session, and the sizes of the groups.
 *
 * @param planned number of planned participants
 * @param sessions the sessions, in order of participants and numbers
 * @param groups the groups, in the study's order of conditions
 */
public record StudyStatus(String study, int planned, List<Row> sessions, List<Group> groups) {

  /** The state of a session. */
  public enum State {
    FINISHED,
    /** Ended by the experimenter. */
    ABORTED,
    /** The participant did not consent. */
    REFUSED,
    /** Neither finished nor ended: the session is running, or was interrupted. */
    OPEN
  }

  /**
   * A row of the sessions.
   *
   * @param condition empty before it is assigned
   * @param missing ids of the steps that are not finished
   * @param flags the quality flags
   * @param excluded whether {@code collect} leaves the session out because of a flag
   */
  public record Row(
      String participant,
      int session,
      String condition,
      State state,
      List<String> missing,
      List<SessionFlagEvent> flags,
      boolean excluded) {
    /** Returns the flags without their steps, each once. */
    public List<SessionFlag> raised() {
      return flags.stream().map(SessionFlagEvent::flag).distinct().toList();
    }

    /** Describes the flags for people, each once, though several steps may have it. */
    public List<String> notes() {
      return flags.stream().map(SessionFlagEvent::note).distinct().toList();
    }
  }

  /**
   * A group: the participants of a condition.
   *
   * @param planned number of planned participants, rounded up if the groups cannot be equal
   * @param assigned number of assigned participants
   * @param finished number of participants with a finished session
   * @param counting number of participants with a finished session that the study does not exclude
   */
  public record Group(String condition, int planned, int assigned, int finished, int counting) {}

  /**
   * Reads the status from the study's folder.
   *
   * @param problems receives the damage of journals
   * @throws IOException if a file cannot be read
   */
  public static StudyStatus of(LoadedStudy material, ProblemCollector problems) throws IOException {
    List<Row> rows = new ArrayList<>();
    Set<String> finished = new HashSet<>();
    Set<String> counting = new HashSet<>();
    for (SessionFolder folder : SessionFolder.all(material.study())) {
      SessionHistory history = SessionHistory.read(folder.journal());
      history.tellDamage(folder.journal(), problems);
      Row row = row(material, folder, history);
      rows.add(row);
      if (history.over()) {
        finished.add(folder.participant());
        if (!row.excluded()) {
          counting.add(folder.participant());
        }
      }
    }
    List<ParticipantsFile.Assigned> assigned = new ParticipantsFile(material.study()).all();
    List<Group> groups = new ArrayList<>();
    int count = material.study().design().groups().size();
    for (StudyGroup group : material.study().design().groups()) {
      List<ParticipantsFile.Assigned> members =
          assigned.stream().filter(member -> member.group().equals(group.name())).toList();
      groups.add(
          new Group(
              group.name(),
              (material.study().participants() + count - 1) / count,
              members.size(),
              among(members, finished),
              among(members, counting)));
    }
    return new StudyStatus(material.study().name(), material.study().participants(), rows, groups);
  }

  /**
   * Returns this status without the conditions, for the experimenter of a blind study: sessions
   * have none, and all groups are one, as the sizes of groups tell whose turn it was.
   */
  public StudyStatus blinded() {
    Group all =
        new Group(
            "all",
            planned,
            groups.stream().mapToInt(Group::assigned).sum(),
            groups.stream().mapToInt(Group::finished).sum(),
            groups.stream().mapToInt(Group::counting).sum());
    List<Row> rows =
        sessions.stream()
            .map(
                row ->
                    new Row(
                        row.participant,
                        row.session,
                        row.condition.isEmpty() ? "" : "hidden",
                        row.state,
                        row.missing,
                        row.flags,
                        row.excluded))
            .toList();
    return new StudyStatus(study, planned, rows, List.of(all));
  }

  private static int among(List<ParticipantsFile.Assigned> members, Set<String> participants) {
    return (int)
        members.stream().filter(member -> participants.contains(member.participant())).count();
  }

  private static Row row(LoadedStudy material, SessionFolder folder, SessionHistory history) {
    return new Row(
        folder.participant(),
        folder.number(),
        history.group().orElse(""),
        history.over()
            ? State.FINISHED
            : history.refused() ? State.REFUSED : history.aborted() ? State.ABORTED : State.OPEN,
        history.over()
            ? List.of()
            : material.steps().stream()
                .filter(step -> !history.finished(step))
                .map(SessionStep::id)
                .toList(),
        history.flags(),
        !history.excluding(material.study().quality()).isEmpty());
  }

  /** Returns the status as text for people. */
  public String text() {
    StringBuilder text = new StringBuilder();
    long finished = sessions.stream().filter(row -> row.state == State.FINISHED).count();
    text.append(
        String.format(
            Locale.ROOT,
            "%s: %d of %d planned participants have finished a session%s%n%n",
            ControlCharacterEscaper.line(study),
            groups.stream().mapToInt(Group::finished).sum(),
            planned,
            excluded()));
    text.append(
        String.format(
            Locale.ROOT, "%-12s %8s %9s %9s%n", "group", "planned", "assigned", "finished"));
    for (Group group : groups) {
      text.append(
          String.format(
              Locale.ROOT,
              "%-12s %8d %9d %9d%n",
              ControlCharacterEscaper.line(group.condition),
              group.planned,
              group.assigned,
              group.finished));
    }
    if (!sessions.isEmpty()) {
      text.append(
          String.format(
              Locale.ROOT,
              "%n%s, %d finished%n%-14s %-10s %-10s %s%n",
              Pluralizer.of(sessions.size(), "session"),
              finished,
              "session",
              "condition",
              "state",
              "missing"));
    }
    for (Row row : sessions) {
      String notes =
          (row.excluded ? " LEFT OUT" : "")
              + (row.flags.isEmpty() ? "" : " (" + String.join(", ", row.notes()) + ")");
      text.append(
          String.format(
                  Locale.ROOT,
                  "%-14s %-10s %-10s %s%s",
                  String.format(Locale.ROOT, "%s ses-%02d", row.participant, row.session),
                  row.condition.isEmpty() ? "-" : ControlCharacterEscaper.line(row.condition),
                  row.state.name().toLowerCase(Locale.ROOT),
                  row.missing.isEmpty() ? "nothing" : String.join(", ", row.missing),
                  notes)
              .stripTrailing());
      text.append(System.lineSeparator());
    }
    return text.toString().replace("\r\n", "\n");
  }

  private String excluded() {
    int left = groups.stream().mapToInt(group -> group.finished - group.counting).sum();
    return switch (left) {
      case 0 -> "";
      case 1 -> "; 1 is left out of the answers, as the study excludes it";
      default -> "; " + left + " are left out of the answers, as the study excludes them";
    };
  }

  /** Returns the status as JSON, several lines. */
  public String json() {
    ObjectNode root = JsonTree.object();
    root.put("study", study);
    root.put("participants", planned);
    ArrayNode all = root.putArray("groups");
    for (Group group : groups) {
      all.addObject()
          .put("condition", group.condition)
          .put("planned", group.planned)
          .put("assigned", group.assigned)
          .put("finished", group.finished)
          .put("counting", group.counting);
    }
    ArrayNode list = root.putArray("sessions");
    for (Row row : sessions) {
      ObjectNode node = list.addObject();
      node.put("participant", row.participant);
      node.put("session", row.session);
      node.put("condition", row.condition);
      node.put("state", row.state.name().toLowerCase(Locale.ROOT));
      row.missing.forEach(node.putArray("missing")::add);
      row.notes().forEach(node.putArray("notes")::add);
      ArrayNode flags = node.putArray("flags");
      row.flags.forEach(
          raised ->
              flags.addObject().put("flag", raised.flag().spelling()).put("step", raised.step()));
      node.put("excluded", row.excluded);
    }
    return JsonWriter.of(root);
  }
}
