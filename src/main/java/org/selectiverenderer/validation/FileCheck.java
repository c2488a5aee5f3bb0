package org.selectiverenderer.validation;

/** Looks at one file by itself. Without state: one object serves all threads. */
public interface FileCheck {
  void check(FileView file, Findings findings);
}
