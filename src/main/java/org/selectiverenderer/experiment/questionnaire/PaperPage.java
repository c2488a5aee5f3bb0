package org.selectiverenderer.experiment.questionnaire;

import java.text.MessageFormat;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.selectiverenderer.base.markup.Markup;
import org.selectiverenderer.experiment.study.QuestionKind;

/** A questionnaire on paper: one HTML page, a sheet for each area, laid out as thesis Fig 86. */
public final class PaperPage {
  private static final String STYLE =
      """
      body{font:11pt/1.35 sans-serif;margin:1.5cm;color:#000}
      section{break-after:page}
      table{border-collapse:collapse;width:100%}
      th,td{border:1px solid #555;padding:2px 6px;text-align:center}
      th{font-weight:normal;font-size:9pt}
      td:first-child{text-align:left}
      tr{break-inside:avoid}
      """;

  private final Wording wording;

  private PaperPage(Wording wording) {
    this.wording = wording;
  }

  /** The page of a participant. */
  public static String html(List<Screen> screens, Wording wording, String participant) {
    PaperPage page = new PaperPage(wording);
    return "<!DOCTYPE html>\n<html lang=\"%s\">\n<head><meta charset=\"utf-8\"><title>%s</title>\n<style>\n%s</style></head>\n<body>\n%s</body>\n</html>\n"
        .formatted(
            Markup.attribute(wording.language()),
            Markup.attribute(wording.of("form.id") + " " + participant),
            STYLE,
            screens.stream()
                .map(screen -> page.section(screen, participant))
                .collect(Collectors.joining()));
  }

  private String section(Screen screen, String participant) {
    String kind = screen.kind().spelling();
    String area = wording.area(screen.area());
    StringBuilder html = new StringBuilder("<section>\n");
    html.append(
        "<p>%s: %s</p>\n"
            .formatted(Markup.attribute(wording.of("form.id")), Markup.attribute(participant)));
    html.append("<h2>%s</h2>\n".formatted(Markup.attribute(filled(kind + ".title", area))));
    html.append("<p>%s</p>\n".formatted(Markup.attribute(filled(kind + ".text", area))));
    html.append("<p>%s</p>\n<table>\n".formatted(Markup.attribute(wording.of("print.hint"))));
    html.append(screen.kind() == QuestionKind.RECOGNITION ? heading() : "");
    for (QuestionItem item : screen.items()) {
      html.append("<tr><td>").append(Markup.attribute(wording.name(item))).append("</td>");
      html.append(
          screen.kind() == QuestionKind.RECOGNITION
              ? cell(wording.of("yes")) + cell(wording.of("no")) + numbers(5)
              : cell(wording.of("expectancy.least"))
                  + numbers(6)
                  + cell(wording.of("expectancy.most")));
      html.append("</tr>\n");
    }
    return html.append("</table>\n</section>\n").toString();
  }

  private String heading() {
    String levels =
        IntStream.rangeClosed(1, 5)
            .mapToObj(
                level ->
                    "<th>"
                        + Markup.attribute(wording.of("recognition.confidence." + level))
                        + "</th>")
            .collect(Collectors.joining());
    return "<tr><th rowspan=\"2\"></th><th colspan=\"2\" rowspan=\"2\">%s</th><th colspan=\"5\">%s</th></tr>\n<tr>%s</tr>\n"
        .formatted(
            Markup.attribute(wording.of("recognition.question")),
            Markup.attribute(wording.of("recognition.confidence")),
            levels);
  }

  private static String numbers(int most) {
    return IntStream.rangeClosed(1, most)
        .mapToObj(number -> cell(String.format(Locale.ROOT, "%d", number)))
        .collect(Collectors.joining());
  }

  private static String cell(String text) {
    return "<td>" + Markup.attribute(text) + "</td>";
  }

  private String filled(String key, String area) {
    return fill(wording.of(key), area);
  }

  /** Words with what their braces stand for. */
  public static String fill(String pattern, Object... values) {
    return new MessageFormat(pattern.replace("'", "''"), Locale.ROOT).format(values);
  }
}
