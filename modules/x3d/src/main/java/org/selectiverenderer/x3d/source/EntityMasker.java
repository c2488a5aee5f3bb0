package org.selectiverenderer.x3d.source;

/**
 * Masks the entity references in the attributes of a text by placeholder characters of the same
 * length, so that a parser without entity expansion can read the text with unchanged offsets, as an
 * edited text needs. References in element content are kept and reported by the parser.
 */
final class EntityMasker extends EntityReferenceScanner {
  private final char[] masked;

  private EntityMasker(CharSequence text, EntityTable entities) {
    super(entities);
    this.masked = new char[text.length()];
    for (int i = 0; i < masked.length; i++) {
      masked[i] = text.charAt(i);
    }
  }

  /**
   * Returns the masked text.
   *
   * @param shift a number that converts offsets in the text to those in the source
   * @throws XmlParseException if the expansions of the references are too long
   */
  static SourceText of(SourceText text, EntityTable entities, ElementSource source, int shift)
      throws XmlParseException {
    EntityMasker mask = new EntityMasker(text, entities);
    try {
      mask.scan(text, shift == 0 && text.length() >= entities.end() ? entities.end() : 0);
    } catch (TooLong e) {
      throw new XmlParseException(e.fault(source, shift));
    }
    return SourceText.of(new String(mask.masked));
  }

  @Override
  void attribute(CharSequence text, int at, int end, String name, char quote) throws TooLong {
    spend(end - at + entities.value(name).map(String::length).orElse(0), at);
    for (int i = at; i < end; i++) {
      masked[i] = '_';
    }
  }
}
