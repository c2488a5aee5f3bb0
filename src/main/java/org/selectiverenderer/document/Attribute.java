package org.selectiverenderer.document;

/**
 * An attribute as it stands in a start tag.
 *
 * @param name as it is written, prefix included
 * @param from offset of the name
 * @param valueFrom offset of the value, behind its quote
 * @param valueTo offset of the quote that ends it
 * @param value with references replaced and white space as XML reads it
 */
public record Attribute(String name, int from, int valueFrom, int valueTo, String value) {
  /** The offset behind its closing quote. */
  public int to() {
    return valueTo + 1;
  }
}
