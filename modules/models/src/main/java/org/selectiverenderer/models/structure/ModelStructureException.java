package org.selectiverenderer.models.structure;

/** Tells that a model is not read; the message is a clause that follows the file's name. */
public final class ModelStructureException extends Exception {
  private static final long serialVersionUID = 1;

  ModelStructureException(String message) {
    super(message);
  }
}
