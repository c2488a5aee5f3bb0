package org.selectiverenderer.study.questionnaire.paper;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.Base64;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.selectiverenderer.base.files.InputFileReader;
import org.selectiverenderer.base.markup.MarkupEscaper;
import org.selectiverenderer.study.questionnaire.AnswerField;
import org.selectiverenderer.study.questionnaire.BranchingRule;
import org.selectiverenderer.study.questionnaire.ChoiceOption;
import org.selectiverenderer.study.questionnaire.ParticipantMessages;
import org.selectiverenderer.study.questionnaire.Question;
import org.selectiverenderer.study.questionnaire.Questionnaire;
import org.selectiverenderer.study.questionnaire.QuestionnairePage;
import org.selectiverenderer.study.questionnaire.RankingField;
import org.selectiverenderer.study.questionnaire.SliderField;

/**
 * Renders questionnaires for printing: one self-contained HTML page, a sheet for each page of a
 * questionnaire, recognition lists laid out as in thesis Fig 86.
 */
public final class PaperQuestionnaireHtml {
  private static final String STYLE =
      """
      body{font:11pt/1.4 sans-serif;margin:1.5cm;color:#000}
      section{break-after:page}
      h2{margin:.6em 0 .3em}
      .id{font-size:9pt;color:#444;margin:0}
      table{border-collapse:collapse;width:100%}
      th,td{border:1px solid #777;padding:3px 6px;text-align:center}
      th{font-weight:normal;font-size:9pt}
      td:first-child{text-align:left}
      tr,.question{break-inside:avoid}
      .question{margin:.9em 0}
      .question p{margin:.1em 0}
      .options{list-style:none;padding-left:1em;margin:.2em 0}
      .box{display:inline-block;width:.8em;height:.8em;border:1px solid #000;margin-right:.5em}
      .line{border-bottom:1px solid #000;height:1.7em}
      .line.rank{display:inline-block;width:2em;height:1.3em;margin-right:.5em}
      .line.short{display:inline-block;width:9em;height:1.3em}
      .slider{display:grid;grid-template-columns:3cm 10.8cm 3cm;align-items:start;gap:.2cm}
      .slider :first-child{text-align:right}
      .slider svg{width:10.8cm}
      .when{font-size:9pt;font-style:italic}
      small{font-size:8pt;display:block}
      .options img{max-width:5cm;max-height:4cm;vertical-align:middle}
      img{max-width:100%;max-height:10cm}
      """;

  private final ParticipantMessages wording;

  private PaperQuestionnaireHtml(ParticipantMessages wording) {
    this.wording = wording;
  }

  /**
   * Returns the HTML page of a participant.
   *
   * @throws IOException if a picture cannot be read
   */
  public static String html(
      List<Questionnaire> questionnaires, ParticipantMessages wording, String participant)
      throws IOException {
    PaperQuestionnaireHtml page = new PaperQuestionnaireHtml(wording);
    try {
      return "<!DOCTYPE html>\n<html lang=\"%s\">\n<head><meta charset=\"utf-8\"><title>%s</title>\n<style>\n%s</style></head>\n<body>\n%s</body>\n</html>\n"
          .formatted(
              MarkupEscaper.attribute(wording.language()),
              MarkupEscaper.attribute(wording.of("form.id") + " " + participant),
              STYLE,
              questionnaires.stream()
                  .flatMap(
                      questionnaire ->
                          questionnaire.pages().stream()
                              .map(sheet -> page.section(questionnaire, sheet, participant)))
                  .collect(Collectors.joining()));
    } catch (UncheckedIOException e) {
      throw e.getCause();
    }
  }

  private String section(Questionnaire questionnaire, QuestionnairePage page, String participant) {
    StringBuilder html = new StringBuilder("<section>\n");
    html.append(
        "<p class=\"id\">%s: %s &middot; %s</p>\n"
            .formatted(
                MarkupEscaper.attribute(wording.of("form.id")),
                MarkupEscaper.attribute(participant),
                MarkupEscaper.attribute(questionnaire.id())));
    if (!page.title().isEmpty()) {
      html.append("<h2>%s</h2>\n".formatted(MarkupEscaper.attribute(page.title())));
    }
    page.when().ifPresent(when -> html.append(condition(questionnaire, when)));
    page.text()
        .lines()
        .filter(line -> !line.isBlank())
        .forEach(line -> html.append("<p>%s</p>\n".formatted(MarkupEscaper.attribute(line))));
    page.picture().ifPresent(file -> html.append(picture(file)));
    if (!page.questions().isEmpty()) {
      html.append("<p>%s</p>\n".formatted(MarkupEscaper.attribute(hint(page))));
      for (QuestionnairePage part : page.parts()) {
        if (!part.stem().isEmpty()) {
          html.append("<p>%s</p>\n".formatted(MarkupEscaper.attribute(part.stem())));
        }
        html.append(questions(questionnaire, part));
      }
    }
    return html.append("</section>\n").toString();
  }

  private String hint(QuestionnairePage page) {
    List<AnswerField> fields =
        page.questions().stream()
            .flatMap(question -> question.kind().fields(wording).stream())
            .toList();
    boolean sliders = fields.stream().anyMatch(SliderField.class::isInstance);
    boolean rankings = fields.stream().anyMatch(RankingField.class::isInstance);
    return wording.of("print.hint")
        + (sliders ? " " + wording.of("print.slider") : "")
        + (rankings ? " " + wording.of("print.ranking") : "");
  }

  private static String picture(Path file) {
    return "<p>%s</p>\n".formatted(image(file, ""));
  }

  private static String image(Path file, String instead) {
    try {
      String kind = file.toString().toLowerCase(Locale.ROOT).endsWith("png") ? "png" : "jpeg";
      return "<img alt=\"%s\" src=\"data:image/%s;base64,%s\">"
          .formatted(
              MarkupEscaper.attribute(instead),
              kind,
              Base64.getEncoder().encodeToString(InputFileReader.bytes(file)));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private String condition(Questionnaire questionnaire, BranchingRule when) {
    String asked =
        questionnaire
            .question(when.question())
            .map(question -> question.text().isEmpty() ? question.id() : question.text())
            .orElse(when.question());
    String values =
        questionnaire
            .question(when.question())
            .map(question -> question.kind().fields(wording).get(0))
            .filter(AnswerField.Choice.class::isInstance)
            .map(AnswerField.Choice.class::cast)
            .map(
                choice ->
                    choice.options().stream()
                        .filter(option -> when.is().contains(option.value()))
                        .map(ChoiceOption::label)
                        .collect(Collectors.joining(", ")))
            .orElse(String.join(", ", when.is()));
    return "<p class=\"when\">%s</p>\n"
        .formatted(MarkupEscaper.attribute(wording.filled("print.when", asked, values)));
  }

  /**
   * Renders the questions as rows of one table if all have the same columns, as in a recognition
   * list; else one by one.
   */
  private String questions(Questionnaire questionnaire, QuestionnairePage page) {
    boolean alike =
        page.questions().stream().allMatch(question -> question.when().isEmpty() && row(question))
            && page.questions().stream().map(this::columns).distinct().count() == 1;
    if (!alike) {
      return page.questions().stream()
          .map(question -> block(questionnaire, question))
          .collect(Collectors.joining());
    }
    StringBuilder html = new StringBuilder("<table>\n").append(heading(page));
    for (Question question : page.questions()) {
      html.append("<tr><td>").append(MarkupEscaper.attribute(question.text())).append("</td>");
      question
          .kind()
          .fields(wording)
          .forEach(field -> html.append(cells((AnswerField.Choice) field, false)));
      html.append("</tr>\n");
    }
    return html.append("</table>\n").toString();
  }

  /** Returns whether a question fits on one row of a table. */
  private boolean row(Question question) {
    return question.kind().fields(wording).stream()
        .allMatch(
            field ->
                field instanceof AnswerField.Choice choice && !choice.several() && choice.inLine());
  }

  /** Returns the columns of a question, for comparison: options and labelled ends of each field. */
  private List<Object> columns(Question question) {
    return question.kind().fields(wording).stream()
        .<Object>map(
            field ->
                field instanceof AnswerField.Choice choice
                    ? List.of(choice.options(), choice.least().isEmpty(), choice.most().isEmpty())
                    : field)
        .toList();
  }

  private String heading(QuestionnairePage page) {
    List<AnswerField> fields = page.questions().get(0).kind().fields(wording);
    List<String> headings = page.headings(wording);
    boolean noted =
        fields.stream()
            .anyMatch(
                field ->
                    field instanceof AnswerField.Choice choice
                        && choice.options().stream().anyMatch(option -> !option.note().isEmpty()));
    StringBuilder first =
        new StringBuilder("<tr><th%s></th>".formatted(noted ? " rowspan=\"2\"" : ""));
    StringBuilder second = new StringBuilder();
    for (int i = 0; i < fields.size(); i++) {
      AnswerField.Choice choice = (AnswerField.Choice) fields.get(i);
      String title = i < headings.size() ? headings.get(i) : "";
      boolean own = choice.options().stream().anyMatch(option -> !option.note().isEmpty());
      int ends = (choice.least().isEmpty() ? 0 : 1) + (choice.most().isEmpty() ? 0 : 1);
      first.append(
          "<th colspan=\"%d\"%s>%s</th>"
              .formatted(
                  choice.options().size() + ends,
                  noted && !own ? " rowspan=\"2\"" : "",
                  MarkupEscaper.attribute(title)));
      if (own) {
        second.append(choice.least().isEmpty() ? "" : "<th></th>");
        choice
            .options()
            .forEach(
                option ->
                    second.append("<th>%s</th>".formatted(MarkupEscaper.attribute(option.note()))));
        second.append(choice.most().isEmpty() ? "" : "<th></th>");
      }
    }
    if (headings.isEmpty() && !noted) {
      return "";
    }
    return first + "</tr>\n" + (noted ? "<tr>" + second + "</tr>\n" : "");
  }

  private String cells(AnswerField.Choice choice, boolean notes) {
    return (choice.least().isEmpty() ? "" : cell(choice.least()))
        + choice.options().stream()
            .map(
                option ->
                    "<td>%s%s</td>"
                        .formatted(
                            MarkupEscaper.attribute(option.label()),
                            notes && !option.note().isEmpty()
                                ? "<small>" + MarkupEscaper.attribute(option.note()) + "</small>"
                                : ""))
            .collect(Collectors.joining())
        + (choice.most().isEmpty() ? "" : cell(choice.most()));
  }

  private static String cell(String text) {
    return "<td>" + MarkupEscaper.attribute(text) + "</td>";
  }

  private String block(Questionnaire questionnaire, Question question) {
    StringBuilder html = new StringBuilder("<div class=\"question\">\n");
    question.when().ifPresent(when -> html.append(condition(questionnaire, when)));
    if (!question.text().isEmpty()) {
      html.append("<p>%s</p>\n".formatted(MarkupEscaper.attribute(question.text())));
    }
    for (AnswerField field : question.kind().fields(wording)) {
      html.append(field(field));
    }
    return html.append("</div>\n").toString();
  }

  private String field(AnswerField field) {
    if (field instanceof AnswerField.Line line) {
      return line.range().isPresent()
          ? "<p><span class=\"line short\"></span> %s</p>\n"
              .formatted(MarkupEscaper.attribute(line.unit()))
          : "<div class=\"line\"></div>\n".repeat(line.lines());
    }
    if (field instanceof SliderField slider) {
      return SliderSvg.figure(slider);
    }
    if (field instanceof RankingField ranking) {
      return ranking.options().stream()
          .map(
              option ->
                  "<li><span class=\"line rank\"></span> %s</li>\n"
                      .formatted(MarkupEscaper.attribute(option.label())))
          .collect(Collectors.joining("", "<ul class=\"options\">\n", "</ul>\n"));
    }
    AnswerField.Choice choice = (AnswerField.Choice) field;
    if (!choice.several() && choice.inLine()) {
      return "<table><tr>%s</tr></table>\n".formatted(cells(choice, true));
    }
    return choice.options().stream()
        .map(
            option ->
                "<li><span class=\"box\"></span>%s</li>\n"
                    .formatted(
                        option
                            .picture()
                            .map(file -> image(file, option.label()))
                            .orElse(MarkupEscaper.attribute(option.label()))))
        .collect(Collectors.joining("", "<ul class=\"options\">\n", "</ul>\n"));
  }
}
