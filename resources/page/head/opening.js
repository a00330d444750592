// The pictures of the run are for readers without scripts: they are not laid out while the views open. They come back where a
// script fails, which an old browser says of one that it cannot read.
(function () {
    var page = document.documentElement;
    page.className = 'opening';
    window.addEventListener('error', function () {
        page.className = page.className.replace('opening', '');
    });
})();
