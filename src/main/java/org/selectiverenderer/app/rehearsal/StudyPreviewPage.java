package org.selectiverenderer.app.rehearsal;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Base64;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.selectiverenderer.base.files.InputFileReader;
import org.selectiverenderer.base.markup.MarkupEscaper;
import org.selectiverenderer.study.design.StudyGroup;
import org.selectiverenderer.study.design.Trial;
import org.selectiverenderer.study.design.TrialPhase;
import org.selectiverenderer.study.design.TrialSequencer;
import org.selectiverenderer.study.questionnaire.AnswerField;
import org.selectiverenderer.study.questionnaire.ChoiceOption;
import org.selectiverenderer.study.questionnaire.Question;
import org.selectiverenderer.study.questionnaire.Questionnaire;
import org.selectiverenderer.study.questionnaire.QuestionnairePage;
import org.selectiverenderer.study.questionnaire.RankingField;
import org.selectiverenderer.study.questionnaire.SliderField;
import org.selectiverenderer.study.questionnaire.paper.SliderSvg;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.SessionStep;

/** Shows all screens of a session, one after the other, on one page. */
public final class StudyPreviewPage {
  private static final String STYLE =
      """
      body{font:11pt/1.4 sans-serif;margin:1.5cm;color:#222;max-width:62em}
      .banner{background:#a00000;color:#fff;padding:.3em 1em;font-weight:bold}
      .screen{border:1px solid #999;padding:1em;margin:1em 0;background:#fafafa}
      .screen.dark{background:#000;color:#fff;text-align:center}
      .note{color:#555;font-size:9pt}
      .slider{display:grid;grid-template-columns:1fr 2fr 1fr;gap:6px}
      .slider :first-child{text-align:right}
      .option img{max-width:180px;max-height:130px}
      .option{display:inline-block;border:1px solid #888;border-radius:4px;padding:1px 9px;margin:2px}
      .line{display:inline-block;border:1px solid #888;background:#fff;width:20em;height:1.4em}
      figure{display:inline-block;margin:.5em}figcaption{font-size:9pt;max-width:480px}
      img{max-width:100%}
      """;

  private final LoadedStudy material;
  private final boolean drawn;
  private final List<StudyView> views;
  private final Consumer<String> message;
  private final StringBuilder html = new StringBuilder();
  private int pictures;

  private StudyPreviewPage(LoadedStudy material, boolean drawn, Consumer<String> message) {
    this.material = material;
    this.drawn = drawn;
    this.message = message;
    views = StudyView.of(material.study());
  }

  /**
   * Returns the page, with a section for each language.
   *
   * @param translations the study in each language that is shown
   * @param drawn whether scenes are drawn, for which OpenGL is needed
   * @param message receives a sentence for each scene that cannot be drawn
   * @throws IOException if a picture of a questionnaire cannot be read
   */
  public static String html(List<LoadedStudy> translations, boolean drawn, Consumer<String> message)
      throws IOException {
    LoadedStudy first = translations.get(0);
    StringBuilder sections = new StringBuilder();
    boolean several = translations.size() > 1;
    if (several) {
      sections.append("<p>");
      translations.forEach(
          one -> sections.append("<a href=\"#%1$s\">%1$s</a> ".formatted(code(one))));
      sections.append("</p>\n");
    }
    for (LoadedStudy material : translations) {
      // The scenes look the same in all languages.
      StudyPreviewPage page =
          new StudyPreviewPage(material, drawn && material.equals(first), message);
      for (SessionStep step : material.steps()) {
        page.step(step);
      }
      sections.append(
          several
              ? "<section id=\"%1$s\" lang=\"%1$s\">\n<h1>%1$s</h1>\n%2$s</section>\n"
                  .formatted(code(material), page.html)
              : page.html);
    }
    String title = MarkupEscaper.attribute("Preview of " + first.study().name());
    return "<!DOCTYPE html>\n<html lang=\"%s\">\n<head><meta charset=\"utf-8\"><title>%s</title>\n<style>\n%s</style></head>\n<body>\n<p class=\"banner\">PREVIEW</p>\n<h1>%s</h1>\n%s</body>\n</html>\n"
        .formatted(code(first), title, STYLE, title, sections);
  }

  private static String code(LoadedStudy material) {
    return MarkupEscaper.attribute(material.wording().language());
  }

  private void step(SessionStep step) throws IOException {
    html.append("<h2>").append(MarkupEscaper.attribute(step.id())).append("</h2>\n");
    if (step instanceof SessionStep.Block block) {
      StudyGroup first = material.study().design().groups().get(0);
      Optional<Trial> trial =
          new TrialSequencer(block.block(), first, material.study().seed())
              .trials(0, 1)
              .flatMap(trials -> trials.stream().findFirst());
      note("a trial of the block, with the first stimulus of the first participant");
      if (trial.isPresent()) {
        for (TrialPhase phase : trial.get().phases()) {
          phase(phase);
        }
      }
      scenes(block.block().name());
    } else if (step instanceof SessionStep.Exposure exposure) {
      note(String.format(Locale.ROOT, "%.1f s, fades not counted", exposure.area().seconds()));
      scenes(exposure.area().name());
    } else if (step instanceof SessionStep.Practice) {
      note("until the experimenter continues");
      scenes("practice");
    } else {
      questionnaire(material.questionnaire(step, "001"));
    }
  }

  private void note(String text) {
    html.append("<p class=\"note\">").append(MarkupEscaper.attribute(text)).append("</p>\n");
  }

  private void dark(String text) {
    html.append("<div class=\"screen dark\">")
        .append(MarkupEscaper.attribute(text).replace("\n", "<br>"))
        .append("</div>\n");
  }

  private void phase(TrialPhase phase) throws IOException {
    if (phase instanceof TrialPhase.Instruction instruction) {
      note("instruction, until the participant goes on");
      dark(instruction.text());
    } else if (phase instanceof TrialPhase.Fixation fixation) {
      note("fixation, %s s".formatted(fixation.seconds()));
      dark("+");
    } else if (phase instanceof TrialPhase.Blank blank) {
      note("blank, " + time(blank.seconds().isPresent(), blank.seconds().orElse(0)));
      dark(" ");
    } else if (phase instanceof TrialPhase.Exposure exposure) {
      note(
          "exposure, "
              + time(exposure.seconds().isPresent(), exposure.seconds().orElse(0))
              + (exposure.response().keys().isEmpty()
                  ? ""
                  : ", keys " + String.join(", ", exposure.response().keys()))
              + "; the pictures follow below");
    } else if (phase instanceof TrialPhase.Feedback feedback) {
      note("feedback, %s s: correct, wrong, no response".formatted(feedback.seconds()));
      dark(feedback.correct() + "\n" + feedback.wrong() + "\n" + feedback.missing());
    } else if (phase instanceof TrialPhase.Questions questions) {
      Optional<Questionnaire> asked = material.inTrials(questions.questionnaire());
      if (asked.isPresent()) {
        questionnaire(asked.get());
      }
    } else if (phase instanceof TrialPhase.Repeat repeat) {
      note("repeated until there is a response, at most %d times:".formatted(repeat.most()));
      for (TrialPhase each : repeat.phases()) {
        phase(each);
      }
    }
  }

  private static String time(boolean known, double seconds) {
    return known ? seconds + " s" : "as long as the level, the area or a response says";
  }

  private void scenes(String step) {
    for (StudyView view : views) {
      if (!view.step().equals(step)) {
        continue;
      }
      if (pictures == StudyCheck.MOST_VIEWS) {
        note("the first %d scenes are drawn; more follow".formatted(pictures));
        pictures++;
      }
      if (pictures > StudyCheck.MOST_VIEWS) {
        continue;
      }
      pictures++;
      html.append("<figure>");
      if (drawn) {
        try {
          picture("png", ScenePicture.png(view, material.study()));
        } catch (IOException e) {
          message.accept("%s cannot be drawn: %s".formatted(view.title(), e.getMessage()));
        }
      }
      html.append("<figcaption>")
          .append(MarkupEscaper.attribute(view.title()))
          .append("</figcaption></figure>\n");
    }
  }

  private void picture(String kind, byte[] bytes) {
    html.append("<img alt=\"\" src=\"data:image/")
        .append(kind)
        .append(";base64,")
        .append(Base64.getEncoder().encodeToString(bytes))
        .append("\">");
  }

  private void questionnaire(Questionnaire questionnaire) throws IOException {
    for (QuestionnairePage page : questionnaire.pages()) {
      page.when()
          .ifPresent(
              when ->
                  note(
                      "only if %s is %s".formatted(when.question(), String.join(", ", when.is()))));
      html.append("<div class=\"screen\">\n");
      if (!page.title().isEmpty()) {
        html.append("<h3>").append(MarkupEscaper.attribute(page.title())).append("</h3>\n");
      }
      page.text()
          .lines()
          .filter(line -> !line.isBlank())
          .forEach(
              line -> html.append("<p>").append(MarkupEscaper.attribute(line)).append("</p>\n"));
      if (page.picture().isPresent()) {
        Path file = page.picture().get();
        picture(kind(file), InputFileReader.bytes(file));
      }
      for (QuestionnairePage part : page.parts()) {
        if (!part.stem().isEmpty()) {
          html.append("<p>").append(MarkupEscaper.attribute(part.stem())).append("</p>\n");
        }
        part.questions().forEach(this::question);
      }
      html.append("</div>\n");
    }
  }

  private void question(Question question) {
    html.append("<p>").append(MarkupEscaper.attribute(question.text()));
    question
        .when()
        .ifPresent(
            when ->
                html.append(" <span class=\"note\">")
                    .append(
                        MarkupEscaper.attribute(
                            "only if %s is %s"
                                .formatted(when.question(), String.join(", ", when.is()))))
                    .append("</span>"));
    html.append("<br>\n");
    for (AnswerField field : question.kind().fields(material.wording())) {
      if (field instanceof SliderField slider) {
        html.append(SliderSvg.figure(slider));
      } else if (field instanceof AnswerField.Choice choice) {
        html.append(choice(choice));
      } else if (field instanceof RankingField ranking) {
        html.append("<br>").append(choice(AnswerField.Choice.of(ranking.options())));
      } else {
        html.append("<span class=\"line\"></span> ");
      }
    }
    html.append("</p>\n");
  }

  private static String choice(AnswerField.Choice choice) {
    return MarkupEscaper.attribute(choice.least())
        + choice.options().stream()
            .map(option -> "<span class=\"option\">" + shown(option) + "</span>")
            .collect(Collectors.joining())
        + MarkupEscaper.attribute(choice.most())
        + " ";
  }

  private static String shown(ChoiceOption option) {
    String label = MarkupEscaper.attribute(option.label());
    try {
      return option.picture().isPresent()
          ? "<img alt=\"%s\" src=\"data:image/%s;base64,%s\">"
              .formatted(
                  label,
                  kind(option.picture().get()),
                  Base64.getEncoder().encodeToString(InputFileReader.bytes(option.picture().get())))
          : label;
    } catch (IOException e) {
      return label; // The picture was there when the study was read.
    }
  }

  private static String kind(Path file) {
    return file.toString().toLowerCase(Locale.ROOT).endsWith("png") ? "png" : "jpeg";
  }
}
