package org.selectiverenderer.experiment.session;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import org.selectiverenderer.base.decimal.Counted;
import org.selectiverenderer.base.json.JsonText;
import org.selectiverenderer.base.json.JsonTree;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.control.Condition;

/**
 * What a study has so far: whose sessions are in what state, how the groups stand.
 *
 * @param planned participants
 * @param sessions in order of participants and numbers
 * @param groups in the study's order
 */
public record StudyStatus(String study, int planned, List<Row> sessions, List<Group> groups) {

  /** How far a session is. */
  public enum State {
    FINISHED,
    /** Ended by the experimenter. */
    ABORTED,
    /** The participant did not consent. */
    REFUSED,
    /** Neither finished nor ended: it is running, or was killed. */
    OPEN
  }

  /**
   * A session.
   *
   * @param condition empty before it is assigned
   * @param missing steps that are not finished
   * @param flags what sets it apart
   * @param excluded whether {@code collect} leaves it out, as the study says of one of its flags
   */
  public record Row(
      String participant,
      int session,
      String condition,
      State state,
      List<String> missing,
      List<RaisedFlag> flags,
      boolean excluded) {
    /** What sets it apart, for people; each once, though several steps may have it. */
    public List<String> notes() {
      return flags.stream().map(RaisedFlag::note).distinct().toList();
    }
  }

  /**
   * A group.
   *
   * @param planned participants; one more in some groups where they cannot be equal
   * @param assigned participants
   * @param finished participants with a finished session
   * @param counting those of them with a finished session that the study does not leave out
   */
  public record Group(String condition, int planned, int assigned, int finished, int counting) {}

  /**
   * Reads it from the study's folder.
   *
   * @param problems hears of journals that are damaged
   * @throws IOException if it cannot be read
   */
  public static StudyStatus of(StudyMaterial material, Problems problems) throws IOException {
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
    List<Participants.Assigned> assigned = new Participants(material.study()).all();
    List<Group> groups = new ArrayList<>();
    int count = material.study().conditions().size();
    for (Condition condition : material.study().conditions()) {
      List<Participants.Assigned> members =
          assigned.stream().filter(member -> member.condition() == condition).toList();
      groups.add(
          new Group(
              condition.spelling(),
              (material.study().participants() + count - 1) / count,
              members.size(),
              among(members, finished),
              among(members, counting)));
    }
    return new StudyStatus(material.study().name(), material.study().participants(), rows, groups);
  }

  private static int among(List<Participants.Assigned> members, Set<String> participants) {
    return (int)
        members.stream().filter(member -> participants.contains(member.participant())).count();
  }

  private static Row row(StudyMaterial material, SessionFolder folder, SessionHistory history) {
    return new Row(
        folder.participant(),
        folder.number(),
        history.condition().map(Condition::spelling).orElse(""),
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

  /** As text for people. */
  public String text() {
    StringBuilder text = new StringBuilder();
    long finished = sessions.stream().filter(row -> row.state == State.FINISHED).count();
    text.append(
        String.format(
            Locale.ROOT,
            "%s: %d of %d planned participants have finished a session%s%n%n",
            study,
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
              group.condition,
              group.planned,
              group.assigned,
              group.finished));
    }
    if (!sessions.isEmpty()) {
      text.append(
          String.format(
              Locale.ROOT,
              "%n%s, %d finished%n%-14s %-10s %-10s %s%n",
              Counted.of(sessions.size(), "session"),
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
                  row.condition.isEmpty() ? "-" : row.condition,
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

  /** As JSON, several lines. */
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
    return JsonText.of(root);
  }
}
