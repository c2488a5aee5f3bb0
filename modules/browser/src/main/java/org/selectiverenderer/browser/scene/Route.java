package org.selectiverenderer.browser.scene;

/** Carries the events of one field to another of the same type (X3D 4.0, 4.4.8.2). */
public record Route(Node from, int fromField, Node to, int toField) {}
