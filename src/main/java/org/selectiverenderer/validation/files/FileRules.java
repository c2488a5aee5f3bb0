package org.selectiverenderer.validation.files;

import java.util.List;
import org.selectiverenderer.validation.RuleGroup;

/** SR3xx: the files that a scene names. */
public final class FileRules {
  private FileRules() {}

  public static RuleGroup group() {
    return new RuleGroup("Files", List.of(), List.of(), List.of());
  }
}
