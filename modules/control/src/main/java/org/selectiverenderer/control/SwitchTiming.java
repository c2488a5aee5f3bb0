package org.selectiverenderer.control;

import java.util.Optional;
import org.web3d.x3d.sai.X3DNode;

/**
 * Decides when a Switch may show another choice. The controller asks on the browser's thread: as an
 * area is entered or left, and for the choices that wait, whenever {@link
 * SelectiveController#showDue} is called.
 */
public interface SwitchTiming {
  /** Every choice is shown at once, as in the thesis. */
  SwitchTiming AT_ONCE =
      new SwitchTiming() {
        @Override
        public boolean mayShow(X3DNode switchNode, int choice) {
          return true;
        }

        @Override
        public Optional<SwitchVisibility> shows(X3DNode switchNode, int choice) {
          return Optional.empty();
        }
      };

  /**
   * Returns whether a Switch may show another choice now; otherwise the choice waits.
   *
   * @param choice the choice that it is to show
   */
  boolean mayShow(X3DNode switchNode, int choice);

  /**
   * Hears that a Switch is about to show another choice, with its old one still in the scene.
   *
   * @param choice the choice that it is to show
   * @return what the viewer sees of the change; empty if that is not known
   */
  Optional<SwitchVisibility> shows(X3DNode switchNode, int choice);
}
