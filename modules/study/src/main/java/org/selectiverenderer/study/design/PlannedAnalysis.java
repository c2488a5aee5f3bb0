package org.selectiverenderer.study.design;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.selectiverenderer.base.problem.SourceLocation;

/**
 * An analysis that the study file plans before there are data.
 *
 * @param name its name in reports
 * @param hypothesis what is expected; empty if it is not said
 * @param measure {@link #MILLISECONDS}, {@link #CORRECT}, {@link #D_PRIME}, {@link #THRESHOLD}, or
 *     the column of a question
 * @param where the cell that a trial must have in each of these columns of the table of trials
 * @param by the factors: those of the study, and columns of the stimuli, which vary within
 *     participants
 * @param aggregate how several trials of a participant at the same levels become one value
 * @param exclude the values that count, by column
 * @param signal of d': the column, and its cell in trials in which there is something to detect;
 *     empty for other measures
 * @param test the model
 * @param place where the file has it
 */
public record PlannedAnalysis(
    String name,
    String hypothesis,
    String measure,
    Map<String, String> where,
    List<String> by,
    Aggregate aggregate,
    Map<String, Limits> exclude,
    Map<String, String> signal,
    Test test,
    SourceLocation place) {
  /** The response time. */
  public static final String MILLISECONDS = "ms";

  /** The share of correct responses. */
  public static final String CORRECT = "correct";

  /** The sensitivity of signal detection. */
  public static final String D_PRIME = "dprime";

  /** The estimate of a staircase. */
  public static final String THRESHOLD = "threshold";

  /** How several values of a participant become one. */
  public enum Aggregate {
    MEAN,
    MEDIAN,
    /** The share of the answers yes and of correct responses. */
    SHARE;

    /** Returns the spelling in a study file. */
    public String spelling() {
      return name().toLowerCase(Locale.ROOT);
    }
  }

  /** The model by which the measure is tested. */
  public enum Test {
    /** Analysis of variance of each participant's values. */
    ANOVA,
    /** Linear, or for correct responses logistic, mixed model of single trials, fitted by R. */
    MIXED_MODEL;

    /** Returns the spelling in a study file. */
    public String spelling() {
      return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }
  }

  /** Values from {@code below} to {@code above} count. */
  public record Limits(double below, double above) {}

  public PlannedAnalysis {
    where = Map.copyOf(where);
    by = List.copyOf(by);
    exclude = Collections.unmodifiableMap(new LinkedHashMap<>(exclude)); // In the file's order.
    signal = Map.copyOf(signal);
  }

  /** Returns whether another one plans the same, wherever it stands in its file. */
  public boolean plansAs(PlannedAnalysis other) {
    return equals(
        new PlannedAnalysis(
            other.name,
            other.hypothesis,
            other.measure,
            other.where,
            other.by,
            other.aggregate,
            other.exclude,
            other.signal,
            other.test,
            place));
  }
}
