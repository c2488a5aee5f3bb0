package org.selectiverenderer.validation;

/**
 * A check of a single file by itself. Implementations are stateless: one instance serves all
 * threads.
 */
public interface FileCheck {
  /** Checks a file and adds the findings. */
  void check(FileContext file, FindingCollector findings);
}
