package org.selectiverenderer.openxr;

import java.util.Set;

/** The functions of OpenXR before there is a runtime. All throw {@link XrFailure}. */
interface XrLoader {
  /** The extensions that the runtime has; the first call that finds out whether there is one. */
  Set<String> extensions();

  /**
   * Connects to the runtime.
   *
   * @param enabled extensions, all of which it has
   */
  XrInstance create(Set<String> enabled);
}
