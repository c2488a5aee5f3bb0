package org.selectiverenderer.statistics.data;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;
import org.selectiverenderer.formats.csv.CsvRow;
import org.selectiverenderer.statistics.detection.Response;

/**
 * Finds objects that the rows of different participants code differently. The consistency of an
 * object is a property of the area, so if it is coded in two ways, all answers to the object are
 * excluded. Its presence may differ by design, when lists are counterbalanced between participants.
 */
final class ObjectCodingCheck {
  private record Item(String area, String object) {}

  private final ExclusionLog exclusions;
  private final boolean counterbalanced;

  /**
   * @param counterbalanced whether objects are meant to be present for some participants only
   */
  ObjectCodingCheck(ExclusionLog exclusions, boolean counterbalanced) {
    this.exclusions = exclusions;
    this.counterbalanced = counterbalanced;
  }

  /**
   * Reports contradictory coding.
   *
   * @param rows the row of each answer
   * @return the answers without those to objects that are coded with two consistencies
   */
  List<Response> consistent(List<Response> responses, Map<Response, CsvRow> rows) {
    Map<Item, List<Response>> items = new LinkedHashMap<>();
    for (Response response : responses) {
      items
          .computeIfAbsent(new Item(response.area(), response.object()), first -> new ArrayList<>())
          .add(response);
    }
    Set<Item> torn = new HashSet<>();
    items.forEach(
        (item, answers) -> {
          if (differ(answers, rows, "consistency", Response::type)) {
            torn.add(item);
          }
          differ(answers, rows, "present", answer -> answer.present() ? "present" : "absent");
        });
    return responses.stream()
        .filter(response -> !torn.contains(new Item(response.area(), response.object())))
        .toList();
  }

  /**
   * Reports answers to an object that differ in a column, at the first answer with the rarest
   * value; returns whether they differ.
   */
  private boolean differ(
      List<Response> answers,
      Map<Response, CsvRow> rows,
      String column,
      Function<Response, String> coding) {
    Map<String, List<Response>> codes = new LinkedHashMap<>();
    for (Response answer : answers) {
      codes.computeIfAbsent(coding.apply(answer), first -> new ArrayList<>()).add(answer);
    }
    if (codes.size() == 1) {
      return false;
    }
    String rare = "";
    String common = "";
    for (Map.Entry<String, List<Response>> code : codes.entrySet()) {
      int size = code.getValue().size();
      rare = rare.isEmpty() || size <= codes.get(rare).size() ? code.getKey() : rare;
      common = common.isEmpty() || size > codes.get(common).size() ? code.getKey() : common;
    }
    Response odd = codes.get(rare).get(0);
    CsvRow row = rows.get(odd);
    if (row == null) {
      throw new IllegalArgumentException("an answer without its row");
    }
    String what =
        "%s (%s) is %s here and %s for %d of %d participants, first in line %d"
            .formatted(
                odd.object(),
                odd.area(),
                rare,
                common,
                codes.get(common).size(),
                answers.size(),
                codes.get(common).get(0).location().line());
    if (column.equals("consistency")) {
      exclusions.error(
          row.location(column), odd.participant(), what + "; all answers to it are left out");
    } else if (!counterbalanced) {
      exclusions.warning(
          row.location(column),
          odd.participant(),
          what
              + "; each answer counts as its row says (use --counterbalanced if that is intended)");
    }
    return true;
  }
}
