package org.selectiverenderer.x3d.source;

/** Blanks what an encoding allows within a value and X3D's fields do not know, such as comments. */
@FunctionalInterface
public interface ValueCleaner {
  /** Blanks characters of the beginning of a buffer; what is left keeps its offsets. */
  void clean(char[] value, int length);
}
