package org.selectiverenderer.models.importer;

/** Tells that a model is not read; the message is a clause that follows the file's name. */
public final class ModelImportException extends Exception {
  private static final long serialVersionUID = 1;

  ModelImportException(String message) {
    super(message);
  }

  ModelImportException(String message, Throwable cause) {
    super(message, cause);
  }
}
