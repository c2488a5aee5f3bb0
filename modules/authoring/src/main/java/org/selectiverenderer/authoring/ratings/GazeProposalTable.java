package org.selectiverenderer.authoring.ratings;

import java.util.List;
import java.util.Locale;
import org.selectiverenderer.schema.ConsistencyType;

/** Formats proposals from head logs as a table of text. */
public final class GazeProposalTable {
  private GazeProposalTable() {}

  /** Returns the table: a header, a line for each proposal, the last one ended. */
  public static String text(List<GazeProposal> proposals) {
    int object = width("object", proposals.stream().map(GazeProposal::object).toList());
    int schema = width("schema", proposals.stream().map(GazeProposal::schema).toList());
    String form = "%-" + object + "s  %-" + schema + "s  %6s  %6s  %-11s  %6s  %9s  %8s  %5s  %s\n";
    StringBuilder text = new StringBuilder();
    text.append(
        line(
            form,
            "object",
            "schema",
            "rating",
            "degree",
            "90% from-to",
            "people",
            "in view s",
            "dwell s",
            "looks",
            "proposed"));
    for (GazeProposal each : proposals) {
      text.append(
          line(
              form,
              each.object(),
              each.schema(),
              each.rating().isPresent() ? fixed(2, each.rating().getAsDouble()) : "-",
              fixed(2, each.degree()),
              fixed(2, each.low()) + "-" + fixed(2, each.high()),
              Integer.toString(each.evidence().participants()),
              fixed(1, each.evidence().inView()),
              fixed(1, each.evidence().dwell()),
              Integer.toString(each.evidence().looks()),
              proposed(each)));
    }
    return text.toString();
  }

  private static String proposed(GazeProposal each) {
    String type = each.type().map(ConsistencyType::spelling).orElse("undecided");
    return each.type().isEmpty() || each.versions() > 1
        ? type
        : type + (each.versions() == 0 ? ", but no Switch" : ", but one version");
  }

  private static int width(String header, List<String> cells) {
    return Math.min(40, cells.stream().mapToInt(String::length).reduce(header.length(), Math::max));
  }

  private static String fixed(int decimals, double number) {
    return String.format(Locale.ROOT, "%." + decimals + "f", number);
  }

  private static String line(String form, Object... cells) {
    return String.format(Locale.ROOT, form, cells);
  }
}
