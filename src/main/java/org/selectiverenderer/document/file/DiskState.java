package org.selectiverenderer.document.file;

/** What has become of a file since it was opened or saved last. */
public enum DiskState {
  SAME,
  /** Somebody else has written it. */
  CHANGED,
  GONE
}
