"""The pictures of docs/gallery.md: a module for each scene, whose build() makes it, what they are made of, and the
program that renders them and writes the page. It needs numpy, and for the page cjpeg (libjpeg-turbo)."""
