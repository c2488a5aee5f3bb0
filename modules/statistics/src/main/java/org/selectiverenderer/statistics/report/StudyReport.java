package org.selectiverenderer.statistics.report;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Locale;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.formats.json.JsonWriter;
import org.selectiverenderer.statistics.detection.DetectionMeasure;
import org.selectiverenderer.statistics.detection.DetectionScore;
import org.selectiverenderer.statistics.study.AreaAnalysis;
import org.selectiverenderer.statistics.study.FamilywiseTest;
import org.selectiverenderer.statistics.study.StudyAnalysis;

/** Writes the report of a study as text, HTML, CSV and JSON. */
public final class StudyReport {
  private StudyReport() {}

  /** Returns the report as plain text for a terminal, without the details of each analysis. */
  public static String text(StudyAnalysis study, Provenance provenance) {
    return TextReportWriter.of(
        StudyReportBuilder.TITLE, StudyReportBuilder.of(study, provenance, false), false);
  }

  /** Returns the complete report as one self-contained HTML page. */
  public static String html(StudyAnalysis study, Provenance provenance) {
    return HtmlReportWriter.of(
        StudyReportBuilder.TITLE, StudyReportBuilder.of(study, provenance, true));
  }

  /** Returns the scores as CSV in tidy (long) format, one score a row. */
  public static String tidyCsv(StudyAnalysis study, Provenance provenance) {
    return ScoresCsvWriter.tidy(study, provenance);
  }

  /** Returns the scores as CSV in wide format, one participant a row. */
  public static String wideCsv(StudyAnalysis study, Provenance provenance) {
    return ScoresCsvWriter.wide(study, provenance);
  }

  /** Returns the complete report as JSON. */
  public static String json(StudyAnalysis study, Provenance provenance) {
    ObjectNode json = JsonTree.object();
    provenance.write(study.responses().source(), json);
    ObjectNode options = json.putObject("options");
    options.put("correction", key(study.scoring().correction()));
    options.put("guessing", key(study.scoring().guessing()));
    options.put("family", key(study.family()));
    AnovaJsonWriter.options(study.options(), options);
    ObjectNode participants = json.putObject("participants");
    study.conditions().forEach(name -> participants.put(name, study.participants(name)));
    AnovaJsonWriter.exclusions(study.responses().exclusions(), json);
    ArrayNode gaps = json.putArray("incomplete");
    for (MissingDataSection.Gap gap : MissingDataSection.gaps(study)) {
      ObjectNode node = gaps.addObject().put("area", gap.area());
      node.put("confidence", gap.level().spelling()).put("without_score", gap.without());
      node.put("participants", gap.participants());
    }
    ArrayNode scores = json.putArray("scores");
    study.scores().forEach(score -> score(score, scores.addObject()));
    ArrayNode analyses = json.putArray("analyses");
    study.analyses().forEach(analysis -> analysis(analysis, analyses.addObject()));
    ArrayNode tests = json.putArray("tests");
    study.tests().forEach(test -> test(test, tests.addObject()));
    ArrayNode ratings = json.putArray("ratings");
    study.ratings().forEach(score -> RatingsJsonWriter.write(score, ratings.addObject()));
    return JsonWriter.of(json);
  }

  private static String key(Enum<?> value) {
    return value.name().toLowerCase(Locale.ROOT).replace('_', '-');
  }

  private static void score(DetectionScore score, ObjectNode json) {
    json.put("participant", score.participant()).put("condition", score.condition());
    json.put("area", score.area()).put("object_type", score.type());
    json.put("confidence", score.level().spelling()).put("objects", score.objects());
    json.put("hits", score.counts().hits()).put("misses", score.counts().misses());
    json.put("false_alarms", score.counts().falseAlarms());
    json.put("correct_rejections", score.counts().correctRejections());
    JsonNumbers.put(json, "hit_rate", score.detection().hitRate());
    JsonNumbers.put(json, "false_alarm_rate", score.detection().falseAlarmRate());
    for (DetectionMeasure measure : DetectionMeasure.values()) {
      JsonNumbers.put(json, measure.key(), measure.of(score.detection()));
    }
    JsonNumbers.put(json, "a_prime", score.detection().aPrime());
    JsonNumbers.put(json, "b_double_prime", score.detection().bDoublePrime());
    score.detection().flaw().ifPresent(flaw -> json.put("undefined", flaw));
  }

  private static void test(FamilywiseTest test, ObjectNode json) {
    json.put("area", test.analysis().area());
    json.put("confidence", test.analysis().level().spelling());
    json.put("measure", test.analysis().measure().key()).put("effect", test.effect().name());
    JsonNumbers.put(json, "p", test.p());
    JsonNumbers.put(json, "p_adjusted", test.adjusted());
    json.put("family_size", test.size());
  }

  private static void analysis(AreaAnalysis analysis, ObjectNode json) {
    json.put("area", analysis.area()).put("confidence", analysis.level().spelling());
    json.put("measure", analysis.measure().key());
    analysis.notes().forEach(json.putArray("notes")::add);
    if (analysis.anova().isPresent() && analysis.evidence().isPresent()) {
      AnovaJsonWriter.write(analysis.anova().get(), analysis.evidence().get(), json);
    } else {
      json.putArray("effects");
      AnovaJsonWriter.descriptives(analysis.design(), json);
    }
  }
}
