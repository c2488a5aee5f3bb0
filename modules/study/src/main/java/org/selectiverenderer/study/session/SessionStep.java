package org.selectiverenderer.study.session;

import org.selectiverenderer.study.definition.Study;
import org.selectiverenderer.study.design.Trial;
import org.selectiverenderer.study.design.TrialBlock;

/** A step of a session. A finished step is never repeated; an interrupted step is begun again. */
public sealed interface SessionStep {
  /** Returns the id in the journal: letters, digits, hyphens. */
  String id();

  /** Returns whether the step shows a scene, for which display and tracker are needed. */
  default boolean shows() {
    return !(this instanceof Form || this instanceof Questions);
  }

  /** The form: consent and questions about the person; after it the condition is assigned. */
  record Form() implements SessionStep {
    @Override
    public String id() {
      return "form";
    }
  }

  /** The practice with display and controls. */
  record Practice(Study.Practice practice) implements SessionStep {
    @Override
    public String id() {
      return "practice";
    }
  }

  /** The exposure to an area. */
  record Exposure(Study.Area area) implements SessionStep {
    @Override
    public String id() {
      return "exposure-" + area.name();
    }
  }

  /** A block of trials, of which each is a {@link OneTrial}. */
  record Block(TrialBlock block) implements SessionStep {
    @Override
    public String id() {
      return block.name();
    }
  }

  /** A trial, a part of its block that is never repeated either, with a head log of its own. */
  record OneTrial(Trial trial) implements SessionStep {
    @Override
    public String id() {
      return trial.id();
    }
  }

  /**
   * A questionnaire.
   *
   * @param name name of the questionnaire in the study
   * @param area the area that it is about; empty for none
   */
  record Questions(String name, String area) implements SessionStep {
    @Override
    public String id() {
      return area.isEmpty() ? name : name + "-" + area;
    }
  }
}
