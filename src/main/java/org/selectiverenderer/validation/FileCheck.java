package org.selectiverenderer.validation;

/** Looks at one file by itself. Without state: one object serves all threads. */
public interface FileCheck {
  /** Looks at a file, and adds what it finds. */
  void check(FileView file, Findings findings);
}
