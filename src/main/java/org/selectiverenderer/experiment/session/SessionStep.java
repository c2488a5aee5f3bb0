package org.selectiverenderer.experiment.session;

import org.selectiverenderer.experiment.study.Study;

/** A part of a session. What is finished is never done again; what was begun is begun anew. */
public sealed interface SessionStep {
  /** By which the journal knows it: letters, digits, hyphens. */
  String id();

  /** Whether it shows a scene, so that displays and trackers are needed. */
  default boolean shows() {
    return this instanceof Practice || this instanceof Exposure;
  }

  /** Consent, and what is asked of the person; then the condition is assigned. */
  record Form() implements SessionStep {
    @Override
    public String id() {
      return "form";
    }
  }

  /** Getting to know display and mouse. */
  record Practice(Study.Practice practice) implements SessionStep {
    @Override
    public String id() {
      return "practice";
    }
  }

  /** Seeing an area. */
  record Exposure(Study.Area area) implements SessionStep {
    @Override
    public String id() {
      return "exposure-" + area.name();
    }
  }

  /**
   * A questionnaire.
   *
   * @param name of it in the study
   * @param area that it is asked about; empty for none in particular
   */
  record Questions(String name, String area) implements SessionStep {
    @Override
    public String id() {
      return area.isEmpty() ? name : name + "-" + area;
    }
  }
}
