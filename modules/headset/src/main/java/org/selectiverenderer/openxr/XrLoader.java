package org.selectiverenderer.openxr;

import java.util.Set;

/**
 * The functions of the OpenXR loader, before there is an instance. All throw {@link
 * XrResultException}.
 */
interface XrLoader {
  /**
   * Returns the extensions that the runtime supports; this is the first call that needs a runtime.
   */
  Set<String> extensions();

  /**
   * Creates an instance, which connects to the runtime.
   *
   * @param enabled extensions to enable, all of which the runtime supports
   */
  XrInstance create(Set<String> enabled);
}
