package org.selectiverenderer.control;

import org.selectiverenderer.schema.SwitchSchemas;
import org.web3d.x3d.sai.X3DNode;

/**
 * An enriched object whose version a budget chooses ({@link SelectiveController#choosable}). It is
 * live: what its methods return follows the scene.
 */
public interface ChoosableObject {
  /** Returns the Switch whose children are the versions. */
  X3DNode node();

  /** Returns the index of the version that is shown. */
  int shown();

  /** Returns the number of versions that the metadata describes. */
  int versions();

  /**
   * Returns the object's degree of consistency with the active schemas, from 0 to 1: that of the
   * version that the areas alone would show ({@link SwitchSchemas}).
   */
  double consistency();
}
