package org.selectiverenderer.control;

import java.util.Optional;
import org.selectiverenderer.schema.SwitchSchemas;
import org.web3d.x3d.sai.grouping.Switch;

/**
 * A property of an object that schemas choose, independently of its others: the version that its
 * Switch shows, or the level of a field.
 */
interface ControlledChoice {
  /** Returns the Switch of the object. */
  Switch node();

  /** Returns the schemas of the choices; empty if there are none at present. */
  Optional<SwitchSchemas> schemas();

  /** Returns the choice that was last set, by the controller or others. */
  int shown();

  /** Returns the child that the Switch shows with a choice. */
  int child(int choice);

  /**
   * Sets a choice, unless it is set already.
   *
   * @return the problem if it could not be set
   */
  Optional<ControlProblem> show(int choice);

  /** Returns the event that tells of a change. */
  ControlEvent change(
      double time, int from, int to, ChoiceCause cause, Optional<SwitchVisibility> seen);
}
