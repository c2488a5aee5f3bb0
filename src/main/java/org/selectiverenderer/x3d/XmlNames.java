package org.selectiverenderer.x3d;

import javax.xml.stream.XMLStreamReader;

/** Names of elements as the reader compares them. */
final class XmlNames {
  private XmlNames() {}

  /**
   * The name without prefix; with it for an element of another language's namespace, such as a
   * signature's {@code ds:Transform}, so that it is not taken for a node.
   */
  static String element(XMLStreamReader xml) {
    String prefix = xml.getPrefix();
    String namespace = xml.getNamespaceURI();
    boolean foreign =
        prefix != null
            && !prefix.isEmpty()
            && namespace != null
            && !namespace.contains("web3d.org");
    return foreign ? prefix + ":" + xml.getLocalName() : xml.getLocalName();
  }
}
