package org.selectiverenderer.export.study;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.base.files.InputFileReader;
import org.selectiverenderer.base.files.Sha256;
import org.selectiverenderer.export.WebScene;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.formats.json.JsonWriter;
import org.selectiverenderer.study.definition.Study;
import org.selectiverenderer.study.questionnaire.Questionnaire;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.PlannedSession;
import org.selectiverenderer.study.session.SessionStep;

/**
 * Describes a study for the page, as {@code study-web.json} and web/src/study/description.ts have
 * it.
 */
final class StudyDescription {
  /** The messages to participants that the page shows beside those that begin with {@code web.}. */
  private static final List<String> WORDS =
      List.of(
          "next",
          "back",
          "left",
          "left.one",
          "page",
          "form.cancel",
          "thanks.title",
          "trial.read",
          "trial.rest");

  private static final String OWN_WORDS = "web.";

  private final List<LoadedStudy> languages;
  private final LoadedStudy first;
  private final Study study;
  private final StudyPictures pictures;

  /**
   * Prepares the description.
   *
   * @param languages the study in each of its languages
   * @param pictures receives the pictures that are shown
   */
  StudyDescription(List<LoadedStudy> languages, StudyPictures pictures) {
    this.languages = List.copyOf(languages);
    this.pictures = pictures;
    first = languages.get(0);
    study = first.study();
  }

  /**
   * Returns the text of the description.
   *
   * @param scenes the exported scenes by their names
   * @param files names of the scenes of trials by their files
   * @throws IllegalArgumentException if the trials of a block have no order, with a sentence
   */
  String text(Map<String, WebScene> scenes, Map<Path, String> files) throws IOException {
    ObjectNode json = JsonTree.object();
    json.put("format", 1);
    json.put("name", study.name());
    json.put("checksum", Sha256.of(InputFileReader.bytes(study.file())));
    study.languages().forEach(json.putArray("languages")::add);
    json.put("fade", study.fade());
    if (study.mute()) {
      json.put("mute", true);
    }
    study.quality().minFps().ifPresent(fps -> json.put("minFps", fps));
    json.put("slowShare", study.quality().slowShare());
    ObjectNode all = json.putObject("scenes");
    for (Map.Entry<String, WebScene> scene : scenes.entrySet()) {
      scene.getValue().describe(all.putObject(scene.getKey()));
    }
    ObjectNode steps = json.putObject("steps");
    first.steps().forEach(step -> describe(step, steps.putObject(step.id())));
    ObjectNode texts = json.putObject("texts");
    languages.forEach(one -> texts(one, texts.putObject(one.study().language())));
    ArrayNode slots = json.putArray("slots");
    Optional<TrialDescription> trials =
        study.design().blocks().isEmpty()
            ? Optional.empty()
            : Optional.of(new TrialDescription(first, files, json.putArray("trials")));
    for (PlannedSession session : PlannedSession.all(first)) {
      ObjectNode slot = slots.addObject();
      describe(session, slot);
      trials.ifPresent(known -> known.orders(session, slot.putObject("trials")));
    }
    return JsonWriter.of(json);
  }

  private void describe(SessionStep step, ObjectNode json) {
    if (step instanceof SessionStep.Exposure exposure) {
      json.put("kind", "exposure");
      json.put("scene", StudyFolder.SCENE);
      json.put("area", exposure.area().name());
      json.put("viewpoint", exposure.area().viewpoint());
      json.put("seconds", exposure.area().seconds());
      json.put("stay", study.stay(exposure.area()).spelling());
    } else if (step instanceof SessionStep.Practice practice) {
      json.put("kind", "practice");
      json.put("scene", StudyFolder.PRACTICE);
      json.put("viewpoint", practice.practice().viewpoint());
    } else if (step instanceof SessionStep.Block block) {
      TrialDescription.describe(block.block(), json);
    } else {
      json.put("kind", step instanceof SessionStep.Form ? "form" : "questions");
    }
  }

  private void texts(LoadedStudy material, ObjectNode json) {
    ObjectNode words = json.putObject("words");
    WORDS.forEach(key -> words.put(key, material.wording().of(key)));
    material.wording().keys(OWN_WORDS).forEach(key -> words.put(key, material.wording().of(key)));
    QuestionnaireDescription describer = new QuestionnaireDescription(material.wording(), pictures);
    ObjectNode pages = json.putObject("questionnaires");
    for (SessionStep step : material.steps()) {
      if (asks(step)) {
        describer.describe(written(material, step), pages.putArray(step.id()));
      }
    }
    for (Questionnaire asked : inTrials(material)) {
      describer.describe(asked, pages.putArray(asked.name()));
    }
    if (!study.design().blocks().isEmpty()) {
      ObjectNode phases = json.putObject("phases");
      material
          .study()
          .design()
          .blocks()
          .forEach(block -> TrialDescription.phases(block.phases(), phases.putArray(block.name())));
    }
  }

  /** Returns the questionnaires that trials ask. */
  private static List<Questionnaire> inTrials(LoadedStudy material) {
    return material.asked().stream()
        .map(LoadedStudy.Asked::questionnaire)
        .filter(one -> material.inTrials(one.name()).filter(one::equals).isPresent())
        .toList();
  }

  private static boolean asks(SessionStep step) {
    return step instanceof SessionStep.Form || step instanceof SessionStep.Questions;
  }

  /** Returns the questionnaire of a step in the order of its file. */
  private static Questionnaire written(LoadedStudy material, SessionStep step) {
    return step instanceof SessionStep.Form
        ? material.form()
        : material.asked().stream()
            .map(LoadedStudy.Asked::questionnaire)
            .filter(one -> one.id().equals(step.id()))
            .findFirst()
            .orElseThrow();
  }

  private void describe(PlannedSession session, ObjectNode json) {
    json.put("slot", session.place() - 1); // a receiver counts from 0
    json.put("participant", session.participant());
    json.put("group", session.group().name());
    json.put("condition", session.group().condition().spelling());
    json.put("seed", (int) study.lot(session.participant()));
    session.steps().forEach(step -> json.withArray("/steps").add(step.id()));
    ParticipantOrder order = new ParticipantOrder(first.wording());
    ObjectNode orders = JsonTree.object();
    for (SessionStep step : session.steps()) {
      if (asks(step)) {
        ObjectNode own =
            order.of(
                written(first, step),
                first.questionnaire(step, session.participant()),
                JsonTree.object());
        if (!own.isEmpty()) {
          orders.set(step.id(), own);
        }
      }
    }
    for (Questionnaire asked : inTrials(first)) {
      ObjectNode own =
          order.of(asked, asked.ordered(study.seed(), session.participant()), JsonTree.object());
      if (!own.isEmpty()) {
        orders.set(asked.name(), own);
      }
    }
    if (!orders.isEmpty()) {
      json.set("order", orders);
    }
  }
}
