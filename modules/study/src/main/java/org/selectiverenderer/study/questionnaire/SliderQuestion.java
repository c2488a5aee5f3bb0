package org.selectiverenderer.study.questionnaire;

import java.math.BigDecimal;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.selectiverenderer.formats.json.JsonObjectReader;

/** A slider between two ends, also known as a visual analogue scale. */
record SliderQuestion(SliderField field) implements QuestionKind {
  /** Spelling of the kind in files. */
  static final String SPELLING = "slider";

  /** Value of {@code start} for a slider without a thumb. */
  private static final String HIDDEN = "hidden";

  private static final double FARTHEST = 1e6;
  private static final double SMALLEST_STEP = 1e-4;

  /**
   * Reads {@code from}, {@code to}, {@code step}, {@code least}, {@code most}, {@code marks},
   * {@code number} and {@code start}.
   */
  static SliderQuestion read(JsonObjectReader keys, Texts texts) {
    BigDecimal from = BigDecimal.valueOf(keys.number("from", -FARTHEST, FARTHEST, 0));
    BigDecimal to = BigDecimal.valueOf(keys.number("to", -FARTHEST, FARTHEST, 100));
    BigDecimal step = BigDecimal.valueOf(keys.number("step", SMALLEST_STEP, FARTHEST, 1));
    BigDecimal length = to.subtract(from);
    if (length.signum() <= 0) {
      keys.fault("to", "\"to\" must be above \"from\"");
      to = from.add(step);
    } else if (length.remainder(step).signum() != 0) {
      keys.fault(
          keys.has("step") ? "step" : "to",
          "a slider from %s to %s cannot be divided into steps of %s"
              .formatted(from.toPlainString(), to.toPlainString(), step.toPlainString()));
      to = from.add(step);
    } else if (length.divide(step).compareTo(BigDecimal.valueOf(SliderField.MOST_STEPS)) > 0) {
      keys.fault(
          keys.has("step") ? "step" : "to",
          "a slider has at most %d steps; make them larger".formatted(SliderField.MOST_STEPS));
      to = from.add(step);
    }
    SliderField field =
        new SliderField(
            from,
            to,
            step,
            texts.optional(keys, "least"),
            texts.optional(keys, "most"),
            keys.truth("marks", false),
            keys.truth("number", false),
            OptionalInt.empty());
    return new SliderQuestion(starting(field, keys));
  }

  private static SliderField starting(SliderField field, JsonObjectReader keys) {
    if (!keys.has("start")
        || keys.value("start").orElseThrow().text().equals(Optional.of(HIDDEN))) {
      return field;
    }
    double number = keys.value("start").orElseThrow().number();
    OptionalInt start =
        Double.isFinite(number) && Math.abs(number) <= FARTHEST
            ? field.position(BigDecimal.valueOf(number).toPlainString())
            : OptionalInt.empty();
    if (start.isEmpty()) {
      keys.fault(
          "start", "\"start\" must be \"hidden\" or a value of the slider, " + field.allowed());
    }
    return new SliderField(
        field.from(),
        field.to(),
        field.step(),
        field.least(),
        field.most(),
        field.marks(),
        field.number(),
        start);
  }

  @Override
  public String spelling() {
    return SPELLING;
  }

  @Override
  public List<String> values() {
    return field.values();
  }

  @Override
  public Optional<SliderField> scale() {
    return Optional.of(field);
  }

  @Override
  public List<AnswerField> fields(ParticipantMessages wording) {
    return List.of(field);
  }
}
